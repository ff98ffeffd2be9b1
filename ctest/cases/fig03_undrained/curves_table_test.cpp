// SPDX-License-Identifier: GPL-2.0-or-later
#include "curves_table.hpp"

#include <gtest/gtest.h>

namespace flowslide {
namespace {

TEST(CurvesTable, HasARowPerCurveAndNanWhereACurveLacksAMetric) {
  EXPECT_EQ(
      curves_table(
          {{"loose", {{"initial_void_ratio", 0.79, "1", ""}, {"peak_shear_stress", 4500.0, "Pa", "of the curve"}}},
           {"dense", {{"initial_void_ratio", 0.75, "1", ""}, {"regained", 2.0, "1", ""}}}}),
      "curve initial_void_ratio peak_shear_stress regained\n"
      "# column 1: curve |  | text | name of the curve | \n"
      "# column 2: initial_void_ratio |  | 1 |  | \n"
      "# column 3: peak_shear_stress |  | Pa | of the curve | \n"
      "# column 4: regained |  | 1 |  | \n"
      "loose 0.79 4500 nan\n"
      "dense 0.75 nan 2\n");
}

TEST(CurvesTable, WithoutCurvesHasItsHeadAlone) {
  EXPECT_EQ(curves_table({}), "curve\n# column 1: curve |  | text | name of the curve | \n");
}

}  // namespace
}  // namespace flowslide
