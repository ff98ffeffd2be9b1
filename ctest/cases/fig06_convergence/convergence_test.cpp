// SPDX-License-Identifier: GPL-2.0-or-later
#include "convergence.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "app/element_test.hpp"
#include "app/slide_run.hpp"

namespace flowslide {
namespace {

constexpr double rounding = 1e-12;

/// tau = factor (1000 + 2e5 gamma) up to 0.4 %, and falling from there to 0 at 0.8 %; 1 % strain in 0.1 s.
double stress_at(double strain, double factor) {
  return factor * (strain <= 4e-3 ? 1000.0 + 2e5 * strain : 1800.0 * std::max(0.0, 2.0 - strain / 4e-3));
}

Result result_of(const Series& empty, double factor, int replicate, double velocity = 0.02, double end = 0.01) {
  Result result;
  result.provenance.replicate = replicate;
  result.series = empty;
  for (int row = 0; row <= std::lround(end / 1e-5); ++row) {
    const double strain = 1e-5 * row;
    std::vector<double> values;
    for (const Column& column : empty.columns)
      values.push_back(column.name == "shear_strain"   ? strain
                       : column.name == "shear_stress" ? stress_at(strain, factor)
                       : column.name == "velocity"     ? velocity
                       : column.name == "rate_asked"   ? 5.0
                       : column.name == "rate_applied" ? 4.0
                                                       : 0.0);
    result.series.append_row(10.0 * strain, values);
  }
  return result;
}
Result slide(double factor, int replicate = 0, double velocity = 0.02) {
  return result_of(slide_series(), factor, replicate, velocity);
}
Result alone(double factor, int replicate = 0) { return result_of(element_test_series(), factor, replicate); }

std::map<std::string, double> compare(const Ensembles& slides) {
  std::map<std::string, double> metrics;
  compare_with_grains(slides, metrics);
  return metrics;
}

TEST(PeakMetrics, FindThePeakOfSlidesAndTests) {
  const auto of_test = peak_metrics(alone(1.0).series);
  ASSERT_EQ(of_test.size(), 2U);
  EXPECT_NEAR(of_test[0].value, 1800.0, 1e-9);
  EXPECT_NEAR(of_test[1].value, 4e-3, rounding);
  const auto of_slide = peak_metrics(slide(1.0).series);
  ASSERT_EQ(of_slide.size(), 3U);
  EXPECT_NEAR(of_slide[2].value, 0.8, rounding);
}

TEST(RelativeError, IsThatOfTheStressAtEqualStrain) {
  EXPECT_NEAR(relative_error(slide(1.1).series, alone(1.0).series), 0.1, rounding);
  EXPECT_NEAR(relative_error(slide(0.7).series, alone(1.0).series), 0.3, rounding);
  EXPECT_EQ(relative_error(alone(1.0).series, alone(1.0).series), 0.0);
  const Series short_one = result_of(slide_series(), 1.0, 0, 0.0, 4e-3).series;
  EXPECT_TRUE(std::isnan(relative_error(short_one, alone(1.0).series)));
}

TEST(RelativeSpread, IsTheDeviationBetweenSamples) {
  EXPECT_NEAR(relative_spread({alone(0.9), alone(1.0, 1), alone(1.1, 2)}), 0.1, rounding);
  EXPECT_TRUE(std::isnan(relative_spread({alone(0.9)})));
}

TEST(CompareWithGrains, TakesTheErrorOnTheSameSample) {
  const auto metrics = compare({{"DEM_low", {alone(0.9), alone(1.0, 1), alone(1.1, 2)}},
                                {"RI_low_1e-3", {slide(0.9), slide(1.02, 1), slide(1.21, 2)}}});
  EXPECT_NEAR(metrics.at("DEM_low.spread"), 0.1, rounding);
  EXPECT_NEAR(metrics.at("RI_low_1e-3.error"), 0.02, rounding);
  EXPECT_NEAR(metrics.at("RI_low_1e-3.error.highest"), 0.1, rounding);
  EXPECT_NEAR(metrics.at("RI_low_1e-3.error_over_spread"), 0.2, 1e-10);
  EXPECT_NEAR(metrics.at("largest_low_error_over_spread"), 1.0, 1e-10);
}

TEST(CompareWithGrains, FollowsTheErrorAsTheStepFalls) {
  const auto metrics = compare({{"DEM_high", {alone(1.0), alone(1.2, 1)}},
                                {"RI_high_1e-3", {slide(0.99)}},
                                {"RI_high_1e-4", {slide(0.97)}},
                                {"RI_high_1e-5", {slide(0.80)}},
                                {"RI_high_1e-6", {slide(0.70, 0, 0.03)}},
                                {"carry_high_1e-3", {slide(1.01)}},
                                {"carry_high_1e-5", {slide(1.02)}},
                                {"carry_high_1e-6", {slide(1.01)}},
                                {"carry30_high_1e-6", {slide(1.0302)}},
                                {"reset_high_1e-3", {slide(1.01)}},
                                {"reset_high_1e-6", {slide(1.05, 0, 0.021)}}});
  EXPECT_NEAR(metrics.at("RI_growth"), 30.0, 1e-9);
  EXPECT_NEAR(metrics.at("RI_least_growth"), 0.3 / 0.2, 1e-9);
  EXPECT_NEAR(metrics.at("carry_growth"), 1.0, 1e-9);
  EXPECT_NEAR(metrics.at("carry_advantage"), 10.0, 1e-9);  // at 1e-5 s; at 1e-6 s it is 30
  EXPECT_NEAR(metrics.at("reset_advantage"), 6.0, 1e-9);
  const double spread = 0.2 / std::sqrt(2.0) / 1.1;
  EXPECT_NEAR(metrics.at("reset_largest_over_spread"), 0.05 / spread, 1e-9);
  EXPECT_NEAR(metrics.at("n_accum_difference_over_spread"), 0.02 / spread, 1e-9);
  EXPECT_NEAR(metrics.at("RI_velocity_change"), 0.5, rounding);
  EXPECT_NEAR(metrics.at("velocity_change_of_RI_over_reset"), 10.0, 1e-9);
}

TEST(CompareWithGrains, TellsWhichSampleAloneIsNearer) {
  const auto metrics = compare({{"DEM_low", {alone(0.6)}},
                                {"DEM_high", {alone(1.0)}},
                                {"RI_high_1e-3", {slide(1.0)}},
                                {"RI_high_1e-6", {slide(0.7)}}});
  EXPECT_NEAR(metrics.at("RI_distance_to_low_over_high"), (0.1 / 0.6) / 0.3, 1e-9);
}

TEST(CompareWithGrains, SaysNothingOfWhatWasNotRun) {
  EXPECT_TRUE(compare({{"RI_low_1e-3", {slide(1.0)}}}).empty());
  const auto metrics = compare({{"DEM_high", {alone(1.0)}}, {"carry_high_1e-3", {slide(1.0)}}});
  EXPECT_FALSE(metrics.contains("carry_growth"));
  EXPECT_FALSE(metrics.contains("velocity_change_of_RI_over_reset"));
}

}  // namespace
}  // namespace flowslide
