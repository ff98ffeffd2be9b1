// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/page.hpp"

#include <gmock/gmock.h>

#include "project.hpp"

namespace flowslide {
namespace {

using testing::HasSubstr;
using testing::Not;

class ReportPage : public testing::Test {
 protected:
  std::string page(const std::string& options = "") {
    const auto results = folder_ / "results";
    return report_page(collect_results(folder_.path(), results, "quick"), {"quick", options, "p {}", results});
  }
  void SetUp() override { write_project(folder_.path()); }
  TemporaryFolder folder_;
};

TEST_F(ReportPage, SaysVerdictsInWords) {
  const std::string html = page();
  EXPECT_THAT(html, HasSubstr("</span> met</span>"));
  EXPECT_THAT(html, HasSubstr("</span> not met</span>"));
  EXPECT_THAT(html, HasSubstr("1 of 2 met"));
  EXPECT_THAT(html, HasSubstr("tau &lt;peaks&gt;."));
  EXPECT_THAT(html, HasSubstr("not measured"));
}

TEST_F(ReportPage, CarriesPicturesAndLinksToData) {
  const std::string html = page();
  EXPECT_THAT(html, HasSubstr("src=\"data:image/png;base64,UE5H\" alt=\"Fig. 3: stress path\""));
  EXPECT_THAT(html, Not(HasSubstr("fig04.png")));
  for (const char* file : {"fig03.pdf", "e0_790.h5", "e0_790.dat", "table.h5"})
    EXPECT_THAT(html, HasSubstr("href=\"shear/quick/" + std::string(file) + "\""));
  EXPECT_THAT(html, HasSubstr("<td>0.5</td>"));
}

TEST_F(ReportPage, SaysWhereRunsComeFrom) {
  const std::string html = page();
  const Provenance from = example_result().provenance;
  EXPECT_THAT(html, HasSubstr(from.git_revision.substr(0, 10)));
  EXPECT_THAT(html, HasSubstr("liggghts 3.8.0"));
  EXPECT_THAT(html, HasSubstr("fig03_undrained --set 'angle=5°'"));
  EXPECT_THAT(html, HasSubstr("torn.h5"));
  EXPECT_THAT(html, HasSubstr("cost: 1 min 15 s of processor time, 1 min 00 s predicted"));
}

TEST_F(ReportPage, TellsTheHealthOfTheSampleOfARun) {
  EXPECT_THAT(page(), Not(HasSubstr("e0 0.7823")));
  Result result = example_result();
  result.metrics = {{"initial_void_ratio", 0.7823, "1", ""},
                    {"initial_probe_void_ratio", 0.767, "1", ""},
                    {"mechanical_coordination_number", 4.6, "1", ""}};
  write_result(folder_ / "results/shear/quick/mixed.h5", result);
  EXPECT_THAT(page(), HasSubstr("e0 0.7823 (probe 0.7670)"));
}

TEST_F(ReportPage, NamesCommandsAndWhatIsMissing) {
  const std::string html = page("--scale paper");
  EXPECT_THAT(html, HasSubstr("./reproduce fig03 fig04 --scale paper<"));
  EXPECT_THAT(html, HasSubstr("./reproduce --report --scale paper<"));
  EXPECT_THAT(html, HasSubstr("<summary>speed: not run at this scale.</summary>"));
}

TEST_F(ReportPage, CountsWhatWasNotRun) {
  const std::string html = page();
  EXPECT_THAT(html, HasSubstr("<dt>Cases not run</dt><dd>1 of 2</dd>"));
  EXPECT_THAT(html, HasSubstr("<dt>Figures</dt><dd>1 of 2</dd>"));
  EXPECT_THAT(html, HasSubstr("<dt>Claims not evaluated</dt><dd>0</dd>"));
}

TEST_F(ReportPage, NeedsNoOtherFile) {
  const std::string html = page();
  EXPECT_THAT(html, Not(testing::ContainsRegex("src=\"[^d]")));
  EXPECT_THAT(html, Not(HasSubstr("stylesheet")));
  EXPECT_THAT(html, Not(HasSubstr("@import")));
}

}  // namespace
}  // namespace flowslide
