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
  for (const Metric& metric : after_pulse({point, series, measures, profiles, Stop::end_time}))
    values[metric.name] = metric.value;
  return values;
}

TEST(AfterPulse, MeasuresVelocityAndStress) {
  const auto metrics = metrics_of(slide(3.0, -0.5));
  EXPECT_NEAR(metrics.at("final_velocity"), 2.0 - 0.5 * 1.95, rounding);
  EXPECT_NEAR(metrics.at("liquefied_shear_stress"), 100.0, 1e-9);
}

TEST(AfterPulse, ComparesTheAccelerationWithThatOfAFreeSlope) {
  const SlopeProperties slope;
  const double free = initial_shear_stress(slope) / mass_per_area(slope);
  const auto metrics = metrics_of(slide(3.0, free));
  // But for the corner at the end of the pulse, which the mean over 0.1 s smooths.
  EXPECT_NEAR(metrics.at("acceleration_share"), 1.0, 0.02);
  EXPECT_NEAR(metrics_of(slide(3.0, 0.0)).at("acceleration_share"), 0.0, 0.02);
}

TEST(AfterPulse, IsNoNumberOfAPulseThatLasts) {
  const auto metrics = metrics_of(slide(0.9, 0.0));
  EXPECT_TRUE(std::isnan(metrics.at("acceleration_share")));
  EXPECT_TRUE(std::isnan(metrics.at("liquefied_shear_stress")));
  EXPECT_NEAR(metrics.at("final_velocity"), 1.7, rounding);
}

TEST(AfterPulse, SaysOfAnyLoadingWhatItCan) {
  const auto metrics = metrics_of(slide(3.0, -0.5), StressTable{{0.0, 1.0}, {0.0, 5e3}});
  EXPECT_TRUE(std::isnan(metrics.at("liquefied_shear_stress")));
  EXPECT_NEAR(metrics.at("final_velocity"), 2.0 - 0.5 * 1.95, rounding);
}

TEST(AfterPulse, LeavesOutWhatAShortRecordDoesNotHave) {
  const auto metrics = metrics_of(slide(0.05, 0.0));
  EXPECT_TRUE(std::isnan(metrics.at("final_velocity")));
  EXPECT_TRUE(std::isnan(metrics.at("acceleration_share")));
}

}  // namespace
}  // namespace flowslide
