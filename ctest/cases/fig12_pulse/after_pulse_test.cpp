// SPDX-License-Identifier: GPL-2.0-or-later
#include "after_pulse.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "experiment/slide_run.hpp"

namespace flowslide {
namespace {

constexpr double rounding = 1e-12;

/// A slope that accelerates at 2 m/s^2 up to t = 1 s and at `after` from then on, tau from 3 kPa to `liquefied`.
Series slide(double end, double after, double liquefied = 100.0) {
  Series series = slide_series();
  for (int row = 0; row <= std::lround(end / 0.01); ++row) {
    const double t = 0.01 * row, late = std::max(t - 1.0, 0.0), early = std::min(t, 1.0);
    const double velocity = 2.0 * early + after * late;
    const double x = early * early + 2.0 * late + 0.5 * after * late * late;
    std::vector<double> values(series.columns.size(), 0.0);
    values[0] = x;
    values[1] = velocity;
    values[2] = x / 0.2;
    values[4] = x / 0.2 < 0.02 ? 3000.0 : liquefied;
    series.append_row(t, values);
  }
  return series;
}

std::map<std::string, double> metrics_of(const Series& series, const StressHistory& loading = SinePulse{3e3, 1.0}) {
  SlidePoint point;
  point.settings.loading = loading;
  const RunMeasures measures = measures_of_rows(series);
  const Series profiles;
  std::map<std::string, double> values;
  for (const Metric& metric : runout_metrics({point, series, measures, profiles, Stop::end_time}))
    values[metric.name] = metric.value;
  return values;
}

TEST(RunoutMetrics, MeasureVelocityAndDistance) {
  const auto metrics = metrics_of(slide(3.0, -0.5));
  // The mean over 0.1 s about the corner at t = 1 s: 2 - (0.05 x 2 + 0.05 x 0.5)/4.
  EXPECT_NEAR(metrics.at("velocity_after_pulse"), 2.0 - (0.1 + 0.025) / 4.0, rounding);
  EXPECT_NEAR(metrics.at("final_velocity"), 2.0 - 0.5 * 1.95, rounding);
  EXPECT_NEAR(metrics.at("final_displacement"), 1.0 + 4.0 - 1.0, rounding);
  EXPECT_NEAR(metrics.at("largest_velocity"), 2.0 - 0.5 * 0.05, 0.01);  // within a quarter of the window of the corner
  EXPECT_EQ(metrics.at("peak_shear_stress"), 3000.0);
  EXPECT_NEAR(metrics.at("liquefied_shear_stress"), 100.0, 1e-9);
}

TEST(RunoutMetrics, CompareTheAccelerationWithThatOfAFreeSlope) {
  const SlopeProperties slope;
  const double free = initial_shear_stress(slope) / mass_per_area(slope);
  const auto metrics = metrics_of(slide(3.0, free));
  // But for the corner at the end of the pulse, which the mean over 0.1 s smooths.
  EXPECT_NEAR(metrics.at("acceleration_share"), 1.0, 0.02);
  EXPECT_NEAR(metrics_of(slide(3.0, 0.0)).at("acceleration_share"), 0.0, 0.02);
}

TEST(RunoutMetrics, AreNoNumberAfterAPulseThatLasts) {
  const auto metrics = metrics_of(slide(0.9, 0.0));
  EXPECT_TRUE(std::isnan(metrics.at("velocity_after_pulse")));
  EXPECT_TRUE(std::isnan(metrics.at("acceleration_share")));
  EXPECT_TRUE(std::isnan(metrics.at("liquefied_shear_stress")));
  EXPECT_NEAR(metrics.at("final_velocity"), 1.7, rounding);
}

TEST(RunoutMetrics, SayOfAnyLoadingWhatTheyCan) {
  const auto metrics = metrics_of(slide(3.0, -0.5), StressTable{{0.0, 1.0}, {0.0, 5e3}});
  EXPECT_TRUE(std::isnan(metrics.at("velocity_after_pulse")));
  EXPECT_TRUE(std::isnan(metrics.at("liquefied_shear_stress")));
  EXPECT_NEAR(metrics.at("final_velocity"), 2.0 - 0.5 * 1.95, rounding);
  EXPECT_EQ(metrics.at("peak_shear_stress"), 3000.0);
}

TEST(RunoutMetrics, LeaveOutWhatAShortRecordDoesNotHave) {
  const auto metrics = metrics_of(slide(0.05, 0.0));
  EXPECT_TRUE(std::isnan(metrics.at("largest_velocity")));
  EXPECT_TRUE(std::isnan(metrics.at("final_velocity")));
  EXPECT_NEAR(metrics.at("final_displacement"), 0.0025, rounding);
}

}  // namespace
}  // namespace flowslide
