// SPDX-License-Identifier: GPL-2.0-or-later
#include "error_table.hpp"

#include <gtest/gtest.h>

namespace flowslide {
namespace {

Ensemble run(double inertial_number, double time_step) {
  Result result;
  result.parameters = {{"inertial_number", inertial_number, "1", ""}, {"time_step", time_step, "s", ""}};
  return {result};
}

TEST(ErrorTable, HasALineForEachStepThatWasRun) {
  const Ensembles slides{{"DEM_high", run(1e-2, 1.0)},           {"DEM_low", run(1e-4, 1.0)},
                         {"RI_high_1e-3", run(1e-2, 1e-3)},      {"variable_high_1e-3", run(1e-2, 1e-3)},
                         {"carry_high_1e-6", run(1e-2, 2.5e-6)},  // dt_G is not that of its name
                         {"carry30_high_1e-5", run(1e-2, 1e-5)}, {"RI_low_1e-3", run(1e-4, 1e-3)}};
  EXPECT_EQ(error_table(slides, {{"RI_high_1e-3.error", 0.00754},
                                 {"RI_high_1e-3.rate_share", 0.9931},
                                 {"variable_high_1e-3.error", 0.005},
                                 {"carry_high_1e-6.error", 0.0072},
                                 {"carry_high_1e-6.rate_share", 1.0},
                                 {"RI_low_1e-3.error", 0.9},
                                 {"carry30_high_1e-5.error", 0.1}}),
            "| dt_G (s) | eq. 15 | eq. 18 as printed | remainder carried | eq. 17 |\n|---|---|---|---|---|\n"
            "| 1e-3 | 0.0075 (0.993) |  |  | 0.005 |\n"
            "| 2.5e-6 |  |  | 0.0072 (1) |  |\n");
}

TEST(ErrorTable, IsEmptyWithoutErrors) {
  EXPECT_EQ(error_table({{"DEM_high", run(1e-2, 1.0)}}, {{"DEM_high.spread", 0.1}}), "");
}

TEST(ErrorTable, HasRowsForAFigure) {
  const Ensembles slides{{"DEM_high", run(1e-2, 1.0)},       {"RI_high_1e-3", run(1e-2, 1e-3)},
                         {"RI_high_1e-4", run(1e-2, 1e-4)},  {"carry_high_1e-6", run(1e-2, 1e-6)},
                         {"reset_high_1e-6", run(1e-2, 1e-6)},  // without an error: it ends early
                         {"carry30_high_1e-6", run(1e-2, 1e-6)}};
  const std::string table = error_rows(slides, {{"RI_high_1e-3.error", 0.01},
                                                {"RI_high_1e-3.error.highest", 0.02},
                                                {"RI_high_1e-4.error", 0.03},
                                                {"carry_high_1e-6.error", 0.25},
                                                {"carry30_high_1e-6.error", 0.5},
                                                {"DEM_high.spread", 0.125}});
  EXPECT_TRUE(table.starts_with("passing time_step error highest spread\n")) << table;
  EXPECT_EQ(table.substr(table.find("\nRI") + 1),
            "RI 0.0001 0.03 nan 0.125\nRI 0.001 0.01 0.02 0.125\ncarry 1e-06 0.25 nan 0.125\n");
}

}  // namespace
}  // namespace flowslide
