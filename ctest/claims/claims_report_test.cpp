// SPDX-License-Identifier: GPL-2.0-or-later
#include <nlohmann/json.hpp>

#include "claims/claims.hpp"
#include "support/messages.hpp"

namespace flowslide {
namespace {

std::vector<Verdict> verdicts() {
  const Claim first{.id = "peak",
                    .figure = "Fig. 3A",
                    .sentence = "It peaks | first.",
                    .metric = "peak",
                    .relation = Relation::greater,
                    .threshold = 2.0,
                    .upper_threshold = 2.0,
                    .unit = "kPa",
                    .origin = "replicate spread",
                    .scales = {}};
  const Claim second{.id = "inertial_number",
                     .figure = "Fig. 3C",
                     .sentence = "I \"exceeds\" 1e-3.",
                     .metric = "none",
                     .relation = Relation::between,
                     .threshold = 0.001,
                     .upper_threshold = 0.5,
                     .unit = "1",
                     .origin = "published",
                     .scales = {}};
  Claim third = second;
  third.id = "fall";
  third.metric = "fall";
  return evaluate({first, second, third}, {{"peak", 2.345678}, {"fall", 4.0}});
}

TEST(TerminalTable, AlignsColumnsAndExplainsWhatIsNotMet) {
  EXPECT_EQ(terminal_table(verdicts()),
            "               figure   claim            expected               measured\n"
            "met            Fig. 3A  peak             > 2 kPa                2.346 kPa\n"
            "not evaluated  Fig. 3C  inertial_number  between 0.001 and 0.5  -\n"
            "         the metric \"none\" was not measured (I \"exceeds\" 1e-3.)\n"
            "NOT MET        Fig. 3C  fall             between 0.001 and 0.5  4\n"
            "         4 is not between 0.001 and 0.5 (I \"exceeds\" 1e-3.)\n");
}

TEST(MarkdownTable, IsATableWhateverTheSentences) {
  EXPECT_EQ(
      markdown_table(verdicts()),
      "| Figure | The paper says | Expected | Measured | Verdict | Origin of the tolerance |\n"
      "|---|---|---|---|---|---|\n"
      "| Fig. 3A | It peaks \\| first. | `peak` > 2 kPa | 2.346 kPa | met | replicate spread |\n"
      "| Fig. 3C | I \"exceeds\" 1e-3. | `none` between 0.001 and 0.5 | - | **not evaluated**: the metric "
      "\"none\" was not measured | published |\n"
      "| Fig. 3C | I \"exceeds\" 1e-3. | `fall` between 0.001 and 0.5 | 4 | **not met**: 4 is not between 0.001 and "
      "0.5 | published |\n");
}

TEST(MarkdownTable, EscapesWhatWouldBeATag) {
  Claim claim{.id = "mean", .figure = "Fig. 10B", .sentence = "<tau> grows by <= 3 and < 4.", .metric = "mean",
              .relation = Relation::less, .threshold = 5.0, .upper_threshold = 5.0, .unit = "1", .origin = "published",
              .scales = {}};
  EXPECT_CONTAINS(markdown_table(evaluate({claim}, {{"mean", 1.0}})),
                  "| Fig. 10B | &lt;tau> grows by <= 3 and < 4. | `mean` < 5 | 1 | met |");
}

TEST(Json, HoldsEachVerdictWithNullForMissingNumbers) {
  const auto read = nlohmann::json::parse(json(verdicts()));
  ASSERT_EQ(read.size(), 3U);
  EXPECT_EQ(read[0].at("id"), "peak");
  EXPECT_EQ(read[0].at("relation"), ">");
  EXPECT_EQ(read[0].at("measured"), 2.345678);
  EXPECT_EQ(read[0].at("met"), true);
  EXPECT_EQ(read[1].at("sentence"), "I \"exceeds\" 1e-3.");
  EXPECT_EQ(read[1].at("threshold"), 0.001);
  EXPECT_EQ(read[1].at("upper_threshold"), 0.5);
  EXPECT_TRUE(read[1].at("measured").is_null());
  EXPECT_TRUE(read[1].at("met").is_null());
  EXPECT_EQ(read[2].at("measured"), 4.0);
  EXPECT_EQ(read[2].at("met"), false);
  EXPECT_EQ(json({}), "[]\n");
}

}  // namespace
}  // namespace flowslide
