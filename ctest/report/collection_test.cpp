// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/collection.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "configuration/error.hpp"
#include "project.hpp"

namespace flowslide {
namespace {

TEST(VerdictsFromJson, AreThoseThatWereWritten) {
  const std::vector<Verdict> verdicts = verdicts_from_json(example_claims);
  ASSERT_EQ(verdicts.size(), 2u);
  EXPECT_EQ(verdicts[0].claim.expectation(), "> 2 kPa");
  EXPECT_EQ(verdicts[0].measurement(), "2.5 kPa");
  EXPECT_EQ(verdicts[0].ruling, Ruling::met);
  EXPECT_EQ(verdicts[1].claim.relation, Relation::between);
  EXPECT_TRUE(std::isnan(verdicts[1].measured));
  EXPECT_EQ(verdicts[1].ruling, Ruling::not_met);
  EXPECT_EQ(verdicts[1].reason, "not measured");
  std::string open = example_claims;
  open.replace(open.find("\"met\": false"), 12, "\"met\": null");
  EXPECT_EQ(verdicts_from_json(open)[1].ruling, Ruling::not_evaluated);
  EXPECT_EQ(json(verdicts_from_json(open)), json(verdicts_from_json(json(verdicts_from_json(open)))));
  const std::vector<Verdict> again = verdicts_from_json(json(verdicts));
  EXPECT_EQ(json(again), json(verdicts));
}

TEST(VerdictsFromJson, RefusesWhatIsNone) {
  for (const char* text : {"", "{", "[{}]", "[1]", R"([{"id": 1}])"})
    EXPECT_THROW(verdicts_from_json(text), std::invalid_argument) << text;
  std::string unknown = example_claims;
  unknown.replace(unknown.find("\">\""), 3, "\"~\"");
  EXPECT_THROW(verdicts_from_json(unknown), std::invalid_argument);
}

TEST(CollectResults, FindsWhatEachCaseHolds) {
  const TemporaryFolder folder;
  write_project(folder.path());
  const std::vector<CaseResults> cases = collect_results(folder.path(), folder / "results", "quick");
  ASSERT_EQ(cases.size(), 2u);
  const CaseResults& shear = cases[0];
  EXPECT_EQ(shear.name, "shear");
  ASSERT_EQ(shear.figures.size(), 2u);
  EXPECT_EQ(shear.figures[0].title, "stress path");
  EXPECT_EQ(shear.figures[0].picture.filename(), "fig03.png");
  EXPECT_TRUE(shear.figures[1].picture.empty());
  EXPECT_EQ(shear.verdicts.size(), 2u);
  ASSERT_EQ(shear.tables.size(), 1u);
  EXPECT_EQ(shear.tables[0].filename(), "table.md");
  ASSERT_EQ(shear.runs.size(), 2u);
  EXPECT_EQ(shear.runs[0].provenance.seed, example_result().provenance.seed);
  EXPECT_EQ(shear.runs[0].problem, "");
  EXPECT_THAT(shear.runs[1].problem, testing::HasSubstr("torn.h5"));
  EXPECT_TRUE(cases[1].empty());
}

TEST(CollectResults, TakesPicturesThatNoListNames) {
  const TemporaryFolder folder;
  write_project(folder.path());
  write_file(folder / "results/speed/quick/pareto.png", "PNG");
  write_file(folder / "results/speed/quick/table.md", "x\n");
  const std::vector<CaseResults> cases = collect_results(folder.path(), folder / "results", "quick");
  ASSERT_EQ(cases[1].figures.size(), 1u);
  EXPECT_EQ(cases[1].figures[0].name, "pareto");
  EXPECT_FALSE(cases[1].empty());
}

TEST(CollectResults, NamesTheFileOfDamagedClaims) {
  const TemporaryFolder folder;
  write_project(folder.path());
  write_file(folder / "results/shear/quick/claims.json", "[{");
  EXPECT_THROW(
      {
        try {
          collect_results(folder.path(), folder / "results", "quick");
        } catch (const ConfigurationError& error) {
          EXPECT_THAT(error.what(), testing::HasSubstr("shear/quick/claims.json"));
          throw;
        }
      },
      ConfigurationError);
}

}  // namespace
}  // namespace flowslide
