// SPDX-License-Identifier: GPL-2.0-or-later
#include "marked_states.hpp"

#include <array>
#include <cmath>

#include "support/messages.hpp"

namespace flowslide::marked_states_test {
namespace {

Result slide(const std::vector<double>& normal_stresses) {
  Result result;
  for (const char* name : {"shear_strain", "velocity", "shear_stress", "normal_stress", "global_inertial_number"})
    result.series.columns.push_back({name, name, "1", name, "", {}});
  double time = 0.0;
  for (const double normal : normal_stresses) {
    result.series.append_row(time, std::array{0.1 * time, 2.0 * time, 1e3 * time, normal, 1e-3 * time});
    time += 1.0;
  }
  result.metrics = {{"time_at_peak", 1.2, "s", ""},
                    {"peak_shear_stress", 1100.0, "Pa", ""},
                    {"normal_stress_at_peak", 9000.0, "Pa", ""}};
  return result;
}

TEST(MarkedStates, LiquefactionIsTheFirstRowBelowOnePercentOfTheInitialNormalStress) {
  const Result result = slide({10000.0, 9000.0, 101.0, 99.0, 5.0});
  EXPECT_EQ(liquefied_row(result.series), 3u);
  EXPECT_DOUBLE_EQ(liquefaction_strain(result.series), 0.3);
  EXPECT_EQ(marked_states_row("RD_ramp", result), "RD_ramp 1.2 1100 9000 2 0.001 3 3000 99 6 0.003\n");
}

TEST(MarkedStates, ASlideThatDoesNotLiquefyHasItsPeakOnly) {
  const Result result = slide({10000.0, 9000.0, 8000.0});
  EXPECT_FALSE(liquefied_row(result.series).has_value());
  EXPECT_TRUE(std::isnan(liquefaction_strain(result.series)));
  EXPECT_EQ(marked_states_row("RI", result), "RI 1.2 1100 9000 2 0.001 nan nan nan nan nan\n");
}

TEST(MarkedStates, ASlideWithoutPeakHasNoRow) {
  Result result = slide({10000.0, 9000.0});
  result.metrics.pop_back();
  EXPECT_EQ(marked_states_row("RD", result), "");
  EXPECT_EQ(marked_states_row("RD", Result{}), "");
}

TEST(MarkedStates, TheHeadNamesEachColumnOfARow) {
  const std::string head = marked_states_head(), names = head.substr(0, head.find('\n'));
  const std::string row = marked_states_row("RD", slide({10000.0, 9000.0}));
  EXPECT_EQ(std::count(names.begin(), names.end(), ' '), std::count(row.begin(), row.end(), ' '));
}

}  // namespace
}  // namespace flowslide::marked_states_test
