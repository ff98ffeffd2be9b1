// SPDX-License-Identifier: GPL-2.0-or-later
#include <limits>

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

TEST(Json, EscapesTextsAndHasNullForMissingNumbers) {
  const std::string text = json(verdicts());
  EXPECT_CONTAINS(text, "\"id\": \"peak\"");
  EXPECT_CONTAINS(text, "\"measured\": 2.345678, \"met\": true");
  EXPECT_CONTAINS(text, "\"sentence\": \"I \\\"exceeds\\\" 1e-3.\"");
  EXPECT_CONTAINS(text, "\"threshold\": 0.001, \"upper_threshold\": 0.5");
  EXPECT_CONTAINS(text, "\"measured\": null, \"met\": null");
  EXPECT_CONTAINS(text, "\"measured\": 4, \"met\": false");
  EXPECT_EQ(text.substr(0, 4), "[\n  ");
  EXPECT_EQ(text.substr(text.size() - 5), "\"}\n]\n");
  EXPECT_EQ(json({}), "[]\n");
}

TEST(DataTable, HasOneRowPerClaimAndTextsInQuotes) {
  EXPECT_EQ(data_table(verdicts()),
            "# id measured threshold upper_threshold unit met figure sentence\n"
            "\"peak\" 2.345678 2 2 \"kPa\" 1 \"Fig. 3A\" \"It peaks | first.\"\n"
            "\"inertial_number\" nan 0.001 0.5 \"1\" NaN \"Fig. 3C\" \"I 'exceeds' 1e-3.\"\n"
            "\"fall\" 4 0.001 0.5 \"1\" 0 \"Fig. 3C\" \"I 'exceeds' 1e-3.\"\n");
}

}  // namespace
}  // namespace flowslide
