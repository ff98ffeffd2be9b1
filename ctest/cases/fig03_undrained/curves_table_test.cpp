// SPDX-License-Identifier: GPL-2.0-or-later
#include "curves_table.hpp"

#include <gtest/gtest.h>

namespace flowslide {
namespace {

TEST(CurvesTable, HasARowPerCurveAndNanWhereACurveLacksAMetric) {
  EXPECT_EQ(curves_table({{"loose", {{"initial_void_ratio", 0.79, "1", ""}, {"peak_shear_stress", 4500.0, "Pa", ""}}},
                          {"dense", {{"initial_void_ratio", 0.75, "1", ""}, {"regained", 2.0, "1", ""}}}}),
            "# curve\tinitial_void_ratio\tpeak_shear_stress\tregained\n"
            "loose\t0.79\t4500\tnan\n"
            "dense\t0.75\tnan\t2\n");
}

TEST(CurvesTable, WithoutCurvesHasItsFirstLineAlone) { EXPECT_EQ(curves_table({}), "# curve\n"); }

}  // namespace
}  // namespace flowslide
