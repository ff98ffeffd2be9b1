// SPDX-License-Identifier: GPL-2.0-or-later
#include "comparison.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "experiment/run_measures.hpp"
#include "experiment/slide_run.hpp"

namespace flowslide {
namespace {

/// tau and sigma stay at these up to 1 % strain, v at `velocity`.
Result slide(double shear, double normal, double velocity = 1.0, int replicate = 0) {
  Result result;
  result.provenance.replicate = replicate;
  result.series = slide_series();
  for (int row = 0; row <= 100; ++row) {
    std::vector<double> values(result.series.columns.size(), 0.0);
    values[0] = 2e-5 * row;
    values[1] = velocity;
    values[2] = 1e-4 * row;
    values[4] = shear;
    values[5] = normal;
    result.series.append_row(row, values);
  }
  result.windows = measures_of_rows(result.series).windows();
  result.metrics = {{"strain_at_peak", 0.01, "1", ""}, {"peak_shear_stress", shear, "Pa", ""},
                    {"linearity_1", 1e-3 * shear, "1", ""}, {"linearity_2", 1e-4 * shear, "1", ""}};
  return result;
}

Result steady(double shear, double friction, int replicate = 0) {
  Result result;
  result.provenance.replicate = replicate;
  result.metrics = {{"steady_shear", shear, "Pa", ""}, {"steady_friction", friction, "1", ""}};
  return result;
}

TEST(Comparison, HoldsTheDifferenceOfSchemesAgainstThatOfSamples) {
  // tau of the samples differs by 200 Pa, a deviation of sqrt(2) x 100 Pa; RD and RI differ by 30 Pa. sigma differs by
  // 60 Pa between RD and RI and by sqrt(2) x 200 Pa between samples.
  std::map<std::string, double> metrics;
  compare_ramps({{"RI_ramp", {slide(1000.0, 5000.0, 2.0), slide(1200.0, 5400.0, 2.0, 1)}},
                 {"RD_ramp", {slide(1030.0, 5060.0, 1.5), slide(1230.0, 5460.0, 1.5, 1)}}},
                metrics);
  EXPECT_NEAR(metrics.at("path_difference_over_spread"), 0.3 / std::sqrt(2.0), 1e-9);
  EXPECT_NEAR(metrics.at("peak_difference_over_spread"), 0.3 / std::sqrt(2.0), 1e-9);
  EXPECT_NEAR(metrics.at("velocity_ratio"), 0.75, 1e-9);
}

TEST(Comparison, ComparesTheSamplesThatBothHave) {
  // RD on samples 1, 2 and 4, RI on 1, 3 and 4: those on one sample differ by 30 and 60 Pa.
  std::map<std::string, double> metrics;
  compare_ramps(
      {{"RI_ramp", {slide(1000.0, 5000.0, 2.0, 0), slide(9000.0, 5000.0, 2.0, 2), slide(1200.0, 5400.0, 2.0, 3)}},
       {"RD_ramp", {slide(1030.0, 5000.0, 1.0, 0), slide(5.0, 5000.0, 1.0, 1), slide(1260.0, 5400.0, 1.0, 3)}}},
      metrics);
  EXPECT_NEAR(metrics.at("peak_difference_over_spread"), std::sqrt(0.5 * (900.0 + 3600.0)) / (100.0 * std::sqrt(2.0)),
              1e-9);
  EXPECT_NEAR(metrics.at("velocity_ratio"), 0.5, 1e-9);
  metrics.clear();
  compare_ramps({{"RI_ramp", {slide(1000.0, 1.0, 1.0, 0), slide(1.0, 1.0, 1.0, 2)}},
                 {"RD_ramp", {slide(1000.0, 1.0, 1.0, 0), slide(1.0, 1.0, 1.0, 1)}}},
                metrics);
  EXPECT_TRUE(metrics.empty());  // one pair has no spread
}

TEST(Comparison, CountsTheExcessOnTheSameSamplesInStandardErrors) {
  // tau of the samples differs by 900 Pa, and RD - RI is 80 and 120 Pa: mean 100, standard error 20.
  std::map<std::string, double> metrics;
  compare_steady_states({{"RD_hold", {steady(110.0, 0.5, 0), steady(1050.0, 0.5, 1), steady(9e9, 0.9, 2)}},
                         {"RI_hold", {steady(930.0, 0.4, 1), steady(30.0, 0.4, 0)}}}, metrics);
  EXPECT_NEAR(metrics.at("shear_excess"), 100.0 / 20.0, 1e-9);
  EXPECT_NEAR(metrics.at("shear_ratio"), 0.5 * (110.0 / 30.0 + 1050.0 / 930.0), 1e-9);
  EXPECT_NEAR(metrics.at("friction_ratio"), 1.25, 1e-9);
  EXPECT_FALSE(metrics.contains("normal_excess"));
}

TEST(Comparison, HasNoStandardErrorOfOneSample) {
  std::map<std::string, double> metrics;
  compare_steady_states({{"RD_hold", {steady(100.0, 0.5)}}, {"RI_hold", {steady(50.0, 0.4)}}}, metrics);
  EXPECT_NEAR(metrics.at("shear_ratio"), 2.0, 1e-9);
  EXPECT_FALSE(metrics.contains("shear_excess"));
}

TEST(Comparison, SaysNothingOfWhatWasNotRun) {
  std::map<std::string, double> metrics;
  compare_ramps({{"RD_ramp", {slide(1.0, 1.0)}}}, metrics);
  compare_steady_states({{"RD_hold", {steady(1.0, 1.0)}}}, metrics);
  EXPECT_TRUE(metrics.empty());
}

}  // namespace
}  // namespace flowslide
