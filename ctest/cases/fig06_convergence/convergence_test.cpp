// SPDX-License-Identifier: GPL-2.0-or-later
#include "convergence.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "experiment/shear_test.hpp"
#include "experiment/slide_run.hpp"

namespace flowslide {
namespace {

constexpr double rounding = 1e-12;

/// tau = factor (1000 + 2e5 gamma) up to 0.4 %, and falling from there to 0 at 0.8 %; 1 % strain in 0.1 s.
double stress_at(double strain, double factor) {
  return factor * (strain <= 4e-3 ? 1000.0 + 2e5 * strain : 1800.0 * std::max(0.0, 2.0 - strain / 4e-3));
}

constexpr double low = 1e-4, high = 1e-2;  ///< inertial numbers

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
  result.windows = measures_of_rows(result.series).windows();
  return result;
}

Result with(Result result, double inertial_number, double time_step = 1.0) {
  result.parameters = {{"inertial_number", inertial_number, "1", ""}, {"time_step", time_step, "s", ""}};
  return result;
}
Result slide(double factor, int replicate = 0, double velocity = 0.02) {
  return result_of(slide_series(), factor, replicate, velocity);
}
Result alone(double factor, int replicate = 0) { return result_of(shear_test_series(), factor, replicate); }

/// The same runs with the inertial number and dt_G that their names say.
Ensembles named(Ensembles slides) {
  for (auto& [name, ensemble] : slides) {
    const double number = name.find("low") != std::string::npos ? low : high;
    const auto step = name.rfind('_');
    for (Result& result : ensemble)
      result = with(result, number, name.starts_with("DEM") ? 1.0 : std::stod(name.substr(step + 1)));
  }
  return slides;
}

std::map<std::string, double> compare(const Ensembles& slides) {
  std::map<std::string, double> metrics;
  compare_with_grains(slides, metrics);
  return metrics;
}

TEST(PeakMetrics, FindThePeakOfSlidesAndTests) {
  const auto of_test = peak_metrics(measures_of_rows(alone(1.0).series));
  ASSERT_EQ(of_test.size(), 3U);
  EXPECT_TRUE(std::isnan(of_test[2].value));  // it is asked for no rate
  EXPECT_NEAR(of_test[0].value, 1800.0, 1e-9);
  EXPECT_NEAR(of_test[1].value, 4e-3, rounding);
  const auto of_slide = peak_metrics(measures_of_rows(slide(1.0).series));
  ASSERT_EQ(of_slide.size(), 3U);
  EXPECT_NEAR(of_slide[2].value, 0.8, rounding);
}

TEST(RelativeError, IsThatOfTheStressAtEqualStrain) {
  EXPECT_NEAR(relative_error(slide(1.1), alone(1.0)), 0.1, rounding);
  EXPECT_NEAR(relative_error(slide(0.7), alone(1.0)), 0.3, rounding);
  EXPECT_EQ(relative_error(alone(1.0), alone(1.0)), 0.0);
  EXPECT_TRUE(std::isnan(relative_error(result_of(slide_series(), 1.0, 0, 0.0, 4e-3), alone(1.0))));
}

TEST(RelativeSpread, IsTheDeviationBetweenSamples) {
  EXPECT_NEAR(relative_spread({alone(0.9), alone(1.0, 1), alone(1.1, 2)}), 0.1, rounding);
  EXPECT_TRUE(std::isnan(relative_spread({alone(0.9)})));
}

TEST(CompareWithGrains, TakesTheErrorOnTheSameSample) {
  const auto metrics = compare(named({{"DEM_low", {alone(0.9), alone(1.0, 1), alone(1.1, 2)}},
                                      {"RI_low_1e-3", {slide(0.9), slide(1.02, 1), slide(1.21, 2)}}}));
  EXPECT_NEAR(metrics.at("DEM_low.spread"), 0.1, rounding);
  EXPECT_NEAR(metrics.at("RI_low_1e-3.error"), 0.02, rounding);
  EXPECT_NEAR(metrics.at("RI_low_1e-3.error.highest"), 0.1, rounding);
  EXPECT_NEAR(metrics.at("RI_low_1e-3.error_over_spread"), 0.2, 1e-10);
  EXPECT_NEAR(metrics.at("largest_low_error_over_spread"), 1.0, 1e-10);
}

TEST(CompareWithGrains, FollowsTheErrorAsTheStepFalls) {
  const auto metrics = compare(named({{"DEM_high", {alone(1.0), alone(1.2, 1)}},
                                      {"RI_high_1e-3", {slide(0.99)}},
                                      {"RI_high_1e-4", {slide(0.97)}},
                                      {"RI_high_1e-5", {slide(0.80)}},
                                      {"RI_high_1e-6", {slide(0.70, 0, 0.03)}},
                                      {"carry_high_1e-3", {slide(1.01)}},
                                      {"carry_high_1e-5", {slide(1.02)}},
                                      {"carry_high_1e-6", {slide(1.01)}},
                                      {"carry30_high_1e-6", {slide(1.0302)}},
                                      {"reset_high_1e-3", {slide(1.01)}},
                                      {"reset_high_1e-6", {slide(1.05, 0, 0.021)}}}));
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
  const auto metrics = compare(named({{"DEM_low", {alone(0.6)}},
                                      {"DEM_high", {alone(1.0)}},
                                      {"RI_high_1e-3", {slide(1.0)}},
                                      {"RI_high_1e-6", {slide(0.7)}}}));
  EXPECT_NEAR(metrics.at("RI_distance_to_low_over_high"), (0.1 / 0.6) / 0.3, 1e-9);
}

TEST(CompareWithGrains, GoesByParametersNotByNames) {
  // A slide that is called low but sheared at the high inertial number, with a dt_G that its name does not have.
  const Ensembles slides{{"DEM_low", {with(alone(0.5), low)}},
                         {"DEM_high", {with(alone(1.0), high)}},
                         {"RI_low_mine", {with(slide(0.9), high, 1e-3)}},
                         {"RI_high_1e-3", {with(slide(0.7), high, 1e-6)}}};
  std::map<std::string, double> metrics;
  compare_with_grains(slides, metrics);
  EXPECT_NEAR(metrics.at("RI_low_mine.error"), 0.1, 1e-9);
  EXPECT_NEAR(metrics.at("RI_growth"), 3.0, 1e-9);
  EXPECT_EQ(alone_of(slides.at("RI_low_mine"), slides), "DEM_high");
  EXPECT_FALSE(metrics.contains("largest_low_error_over_spread"));
}

TEST(CompareWithGrains, SaysNothingOfWhatWasNotRun) {
  EXPECT_TRUE(compare(named({{"RI_low_1e-3", {slide(1.0)}}})).empty());
  const auto metrics = compare(named({{"DEM_high", {alone(1.0)}}, {"carry_high_1e-3", {slide(1.0)}}}));
  EXPECT_FALSE(metrics.contains("carry_growth"));
  EXPECT_FALSE(metrics.contains("velocity_change_of_RI_over_reset"));
}

}  // namespace
}  // namespace flowslide
