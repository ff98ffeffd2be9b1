// SPDX-License-Identifier: GPL-2.0-or-later
#include "comparison.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "experiment/run_measures.hpp"
#include "experiment/slide_run.hpp"

namespace flowslide::comparison_test {
namespace {

/// v = min(sqrt(2 a x), limit) up to x = 4 m after a pulse (kPa), as the replicate of that number.
Result slide(double acceleration, double limit, int replicate = 0, double amplitude = 3.0) {
  Result result;
  result.parameters = {{"amplitude", 1e3 * amplitude, "Pa", ""}};
  result.provenance.replicate = replicate;
  result.series = slide_series();
  double largest = 0.0;
  for (int row = 0; row <= 4000; ++row) {
    const double x = 1e-3 * row, velocity = std::min(std::sqrt(2.0 * acceleration * x), limit);
    std::vector<double> values(result.series.columns.size(), 0.0);
    values[0] = x;
    values[1] = velocity;
    result.series.append_row(1e-3 * row, values);
    largest = std::max(largest, velocity);
  }
  result.windows = measures_of_rows(result.series).windows();
  result.metrics = {{"largest_velocity", largest, "m/s", ""}};
  return result;
}

Series over_displacement(const Result& result) { return windows_over(result, "displacement"); }

TEST(Comparison, FindsWhereTheSchemesPart) {
  // RD stays at 1.8 m/s: a tenth below RI where that has 2 m/s. Places stand 0.05 m apart, dv = a dx/v.
  EXPECT_NEAR(parting_velocity(over_displacement(slide(1.0, 1.8)), over_displacement(slide(1.0, 9.0))), 2.0,
              0.05 / 2.0);
  EXPECT_TRUE(std::isnan(parting_velocity(over_displacement(slide(1.0, 9.0)), over_displacement(slide(1.0, 9.0)))));
}

TEST(Comparison, TakesPairsOnOneSample) {
  std::map<std::string, double> metrics;
  compare_schemes({{"RD_3kPa", {slide(1.0, 1.8, 0), slide(1.0, 0.9, 2), slide(1.0, 9.0, 3)}},
                   {"RI_3kPa", {slide(1.0, 9.0, 2), slide(1.0, 9.0, 3)}}}, metrics);
  EXPECT_NEAR(metrics.at("parting_velocity.median"), 1.0, 0.05);  // the third sample does not part
  EXPECT_FALSE(metrics.contains("RI_growth"));
}

TEST(Comparison, HoldsTheSchemesAgainstEachOtherSampleBySample) {
  // The ranges of RD and RI over the samples overlap, but RI exceeds RD on each of them.
  const auto with = [](Result result, double share, double normal) {
    result.metrics = {{"acceleration_share", share, "1", ""}, {"liquefied_normal_stress", normal, "Pa", ""}};
    return result;
  };
  std::map<std::string, double> metrics;
  compare_schemes({{"RD_3kPa", {with(slide(1.0, 1.8, 0), 0.2, 300.0), with(slide(1.0, 1.8, 1), 0.9, 80.0)}},
                   {"RI_3kPa", {with(slide(1.0, 9.0, 1), 1.0, 20.0), with(slide(1.0, 9.0, 0), 0.5, 150.0)}}},
                  metrics);
  EXPECT_NEAR(metrics.at("acceleration_gap"), 0.1, 1e-12);
  EXPECT_NEAR(metrics.at("RD_normal_stress_over_RI"), 3.0, 1e-12);
}

TEST(Comparison, ComparesAmplitudesOnTheSameSamples) {
  std::map<std::string, double> metrics;
  compare_schemes({{"RI_3kPa", {slide(1.0, 9.0, 1)}},
                   {"RI_mine", {slide(1.44, 9.0, 1, 4.0), slide(9.0, 9.0, 0, 4.0)}},  // parameter, not name
                   {"RI_10kPa", {slide(4.0, 9.0, 1, 10.0)}},
                   {"RD_3kPa", {slide(1.0, 1.5, 0), slide(1.0, 1.6, 1), slide(1.0, 1.9, 2)}},
                   {"RD_4kPa", {slide(1.0, 1.6, 0, 4.0), slide(1.0, 1.9, 1, 4.0), slide(1.0, 2.1, 3, 4.0)}}},
                  metrics);
  EXPECT_NEAR(metrics.at("RI_growth"), 1.2, 1e-9);  // sqrt(1.44), the smaller of the two steps
  EXPECT_NEAR(metrics.at("RD_spread_over_amplitudes"), 0.2, 1e-9);  // of samples 0 and 1: 0.1 and 0.3 m/s
  EXPECT_NEAR(metrics.at("RD_spread_over_seeds"), 0.45, 1e-9);
  EXPECT_NEAR(metrics.at("RD_spread_ratio"), 0.2 / 0.45, 1e-9);
}

TEST(Comparison, SaysNothingOfWhatWasNotRun) {
  std::map<std::string, double> metrics;
  compare_schemes({{"RD_3kPa", {slide(1.0, 1.8)}}}, metrics);
  EXPECT_TRUE(metrics.empty());
  EXPECT_TRUE(std::isnan(parting_velocity(Series{}, over_displacement(slide(1.0, 1.0)))));  // it has not moved
}

}  // namespace
}  // namespace flowslide::comparison_test
