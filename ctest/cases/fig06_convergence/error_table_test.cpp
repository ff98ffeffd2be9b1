// SPDX-License-Identifier: GPL-2.0-or-later
#include "error_table.hpp"

#include <gtest/gtest.h>

namespace flowslide {
namespace {

TEST(ErrorTable, HasALineForEachStepThatWasRun) {
  EXPECT_EQ(error_table({{"RI_high_1e-3.error", 0.00754}, {"RI_high_1e-3.rate_share", 0.9931},
                         {"variable_high_1e-3.error", 0.005}, {"carry_high_1e-6.error", 0.0072},
                         {"carry_high_1e-6.rate_share", 1.0}, {"RI_low_1e-3.error", 0.9}}),
            "| dt_G (s) | eq. 15 | eq. 18 as printed | remainder carried | eq. 17 |\n|---|---|---|---|---|\n"
            "| 1e-3 | 0.0075 (0.993) |  |  | 0.005 |\n"
            "| 1e-6 |  |  | 0.0072 (1) |  |\n");
}

TEST(ErrorTable, IsEmptyWithoutErrors) { EXPECT_EQ(error_table({{"DEM_high.spread", 0.1}}), ""); }

}  // namespace
}  // namespace flowslide
