// SPDX-License-Identifier: GPL-2.0-or-later
#include "choices_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "support/messages.hpp"

namespace flowslide {
namespace {

Ensemble with(std::vector<Metric> metrics, double last_strain = 3.0) {
  Result result;
  result.series.columns = {{"shear_strain", "", "1", "", "", {}}};
  result.series.append_row(last_strain, std::array{last_strain});
  result.metrics = std::move(metrics);
  return {result};
}

TEST(ChoicesTable, HasARowForEachChoiceAndSampleWithARun) {
  Ensemble ri;
  for (const double stops : {1.0, 0.0, 1.0})
    ri.push_back(with({{"velocity_after_pulse", 1 - stops, "m/s", ""}, {"largest_velocity", 1.9 - stops, "m/s", ""},
                       {"stands", stops, "1", ""}}).front());
  const Ensembles runs{{"plain_771_shear", with({{"jams", 0, "1", ""},
                                                 {"liquefied_strain", 0.06, "1", ""},
                                                 {"peak_shear_stress", 6250, "Pa", ""},
                                                 {"initial_void_ratio", 0.785, "1", ""},
                                                 {"initial_probe_void_ratio", 0.766, "1", ""}})},
                       {"plain_771_RD", with({{"velocity_after_pulse", 1.5, "m/s", ""},
                                              {"largest_velocity", 1.75, "m/s", ""},
                                              {"stands", 0, "1", ""}})},
                       {"plain_771_RI", ri},
                       {"glue_765_shear", with({{"jams", 1, "1", ""},
                                                {"liquefied_strain", 0.06, "1", ""},
                                                {"strain_above_10", 0.212, "1", ""},
                                                {"strain_above_1", 0.176, "1", ""}})},
                       {"off_770_1", with({{"jams", 1, "1", ""}})}};
  const std::string table = choices_table(runs);
  EXPECT_CONTAINS(
      table,
      "| 0.771 | none | 0.785, 0.766 | 6.2 | liquid to 300 % | - | 1.50, 1.75; 0 of 1 stand | 0.00, 0.90; 2 "
      "of 3 stand |\n");
  EXPECT_CONTAINS(table, "| 0.765 | glue: outer 5 % of the height | -, - | - | jams from 21 % | 18 | - | - |\n");
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 4);
}

TEST(ChoicesTable, TellsASampleThatDoesNotLiquefy) {
  EXPECT_CONTAINS(choices_table({{"stiffness_5_765_shear", with({{"jams", 1, "1", ""}})}}),
                  "| 0.765 | rolling stiffness 5 | -, - | - | does not liquefy | - | - | - |\n");
}

}  // namespace
}  // namespace flowslide
