// SPDX-License-Identifier: GPL-2.0-or-later
#include "trigger_metrics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "experiment/slide_run.hpp"

namespace flowslide::trigger_metrics_test {
namespace {

constexpr double rounding = 1e-9;

/// tau rises to 4 kPa at 1 % strain and falls to 200 Pa at 10 %, sigma from 28 kPa to 50 Pa at 10 % and up to 400 Pa
/// from 20 % on; I = strain.
Series slide(double end) {
  Series series = slide_series();
  for (int row = 0; row <= std::lround(end / 1e-3); ++row) {
    const double strain = 1e-3 * row;
    std::vector<double> values(series.columns.size(), 0.0);
    values[1] = 3.0 * strain;
    values[2] = strain;
    values[4] = strain <= 0.01 ? 4e5 * strain : strain <= 0.1 ? 4000.0 - (strain - 0.01) / 0.09 * 3800.0 : 200.0;
    values[5] = strain <= 0.1 ? 28000.0 - strain / 0.1 * 27950.0 : strain < 0.2 ? 50.0 : 400.0;
    values[13] = strain;
    series.append_row(0.1 * row, values);
  }
  return series;
}

std::map<std::string, double> metrics_of(const Series& series) {
  std::map<std::string, double> values;
  for (const Metric& metric : trigger_metrics(measures_of_rows(series), series.last("velocity")))
    values[metric.name] = metric.value;
  return values;
}

TEST(TriggerMetrics, FindThePeak) {
  const auto metrics = metrics_of(slide(1.0));
  EXPECT_NEAR(metrics.at("peak_shear_stress"), 4000.0, rounding);
  EXPECT_NEAR(metrics.at("strain_at_peak"), 0.01, rounding);
  EXPECT_NEAR(metrics.at("largest_inertial_number_before_peak"), 0.01, rounding);
  EXPECT_NEAR(metrics.at("time_at_peak"), 1.0, rounding);
  EXPECT_NEAR(metrics.at("normal_stress_at_peak"), 28000.0 - 2795.0, 1e-6);
}

TEST(TriggerMetrics, AverageBeyondHalfStrain) {
  const auto metrics = metrics_of(slide(1.0));
  EXPECT_NEAR(metrics.at("lowest_normal_stress"), 50.0, rounding);
  EXPECT_NEAR(metrics.at("steady_shear"), 200.0, rounding);
  EXPECT_NEAR(metrics.at("steady_normal"), 400.0, rounding);
  EXPECT_NEAR(metrics.at("steady_friction"), 0.5, rounding);
  EXPECT_NEAR(metrics.at("steady_inertial_number"), 0.75, rounding);
  EXPECT_NEAR(metrics.at("final_velocity"), 3.0, rounding);
}

TEST(TriggerMetrics, AreNoNumberWithoutASteadyState) {
  EXPECT_TRUE(std::isnan(metrics_of(slide(0.4)).at("steady_friction")));
}

TEST(TriggerMetrics, GiveFrictionOverStrain) {
  const Series mu = friction(measures_of_rows(slide(2.0)).over_strain);
  EXPECT_EQ(mu.rows(), 60U);
  EXPECT_NEAR(mu.axis.values.back(), 1.4875, rounding);
  EXPECT_NEAR(mu.column("friction").values.back(), 0.5, rounding);
  EXPECT_EQ(friction(measures_of_rows(slide(0.5)).over_strain).rows(), 20U);  // as far as the record goes
}

}  // namespace
}  // namespace flowslide::trigger_metrics_test
