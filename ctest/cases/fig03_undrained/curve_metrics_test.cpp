// SPDX-License-Identifier: GPL-2.0-or-later
#include "curve_metrics.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "claims/claims.hpp"
#include "experiment/shear_test.hpp"

namespace flowslide {
namespace {

constexpr double sigma_0 = 10e3;  // Pa

/// A curve drawn with a ruler, one row per percent of strain up to `last` %, so that every metric follows by hand.
///   shear:  1000 Pa, peak of 3000 at 2 %, straight down to 0 at 17 %, nothing until 30 %, straight up to 2000 at 50 %
///   normal: 10 000 Pa, straight down to 1000 at 18 %, straight up to 2600 at 50 %
Series curve(int last = 50) {
  Series series = shear_test_series();
  for (int k = 0; k <= last; ++k) {
    const double shear = k <= 2 ? 1000.0 + 1000.0 * k : std::max({3000.0 - 200.0 * (k - 2), 100.0 * (k - 30), 0.0});
    const double normal = k <= 18 ? 10000.0 - 500.0 * k : 1000.0 + 50.0 * (k - 18);
    const double inertial = k <= 10 ? 1e-4 : k <= 20 ? 2e-3 : 9e-4;
    const double values[] = {k / 100.0, shear, normal, 0.8 * normal, k == 15 ? 0.5 : inertial, 0.79,
                             shear, normal, k == 3 ? shear + 6.0 : shear, k == 7 ? normal - 9.0 : normal, 1.0, 5.0};
    series.append_row(0.1 * k, values);
  }
  return series;
}

void set(Series& series, const std::string& name, std::size_t row, double value) {
  for (Column& column : series.columns)
    if (column.name == name) column.values[row] = value;
}

std::map<std::string, double> metrics_of(const Series& series) {
  const auto metrics = curve_metrics(series, measures_of_rows(series).peak_to_5, sigma_0);
  EXPECT_NO_THROW(check_metrics(metrics));  // else the result of a whole run could not be written
  std::map<std::string, double> values;
  for (const Metric& metric : metrics) values[metric.name] = metric.value;
  return values;
}

constexpr double rounding = 1e-13;  // of sums of fifty terms of the size of one

TEST(CurveMetrics, FindThePeakOfTheFirstFivePercent) {
  const auto metrics = metrics_of(curve());
  EXPECT_EQ(metrics.at("peak_shear_stress"), 3000.0);
  EXPECT_EQ(metrics.at("strain_at_peak"), 0.02);
  Series later = curve();
  set(later, "shear_stress", 6, 9000.0);  // at 6 %: not of the first peak
  EXPECT_EQ(metrics_of(later).at("peak_shear_stress"), 3000.0);
  set(later, "shear_stress", 5, 3000.0);  // as high again: the first counts
  EXPECT_EQ(metrics_of(later).at("strain_at_peak"), 0.02);
  set(later, "shear_stress", 5, 3001.0);
  EXPECT_EQ(metrics_of(later).at("strain_at_peak"), 0.05);
}

TEST(CurveMetrics, AverageTheLiquefiedPartOverStrain) {
  const auto metrics = metrics_of(curve());
  // From 10 % on, by trapezoids: (8 x 3000 + 32 x 1800) / 40 = 2040 Pa and (7 x 700 + 20 x 1000) / 40 = 622.5 Pa.
  EXPECT_NEAR(metrics.at("mean_liquefied_normal"), 0.2040, rounding);
  EXPECT_NEAR(metrics.at("mean_liquefied_shear"), 0.06225, rounding);
  // More rows in one place do not weigh more.
  Series uneven = shear_test_series();
  const Series even = curve();
  for (std::size_t row = 0; row < even.rows(); ++row) {
    std::vector<double> values, halfway;
    for (const Column& column : even.columns) values.push_back(column.values[row]);
    uneven.append_row(even.axis.values[row], values);
    if (row < 30 || row + 1 == even.rows()) continue;
    for (const Column& column : even.columns) halfway.push_back(0.5 * (column.values[row] + column.values[row + 1]));
    uneven.append_row(even.axis.values[row], halfway);
  }
  EXPECT_NEAR(metrics_of(uneven).at("mean_liquefied_shear"), 0.06225, rounding);
}

TEST(CurveMetrics, FindLossAndRegain) {
  const auto metrics = metrics_of(curve());
  EXPECT_NEAR(metrics.at("lowest_normal"), 0.1, rounding);
  EXPECT_NEAR(metrics.at("regained_shear"), 0.2, rounding);
  EXPECT_NEAR(metrics.at("regain_over_peak"), 2000.0 / 3000.0, rounding);
  Series lower = curve();
  set(lower, "normal_stress", 26, 10.0);  // beyond 25 %: too late for the first liquefaction
  EXPECT_NEAR(metrics_of(lower).at("lowest_normal"), 0.1, rounding);
  set(lower, "normal_stress", 25, 20.0);
  EXPECT_NEAR(metrics_of(lower).at("lowest_normal"), 0.002, rounding);
  set(lower, "shear_stress", 24, 8000.0);  // before 25 %, and now before the lowest normal stress
  EXPECT_NEAR(metrics_of(lower).at("regained_shear"), 0.2, rounding);
  EXPECT_NEAR(metrics_of(lower).at("regain_over_peak"), 2000.0 / 3000.0, rounding);
}

TEST(CurveMetrics, TellHowQuasiStaticTheTestWas) {
  const auto metrics = metrics_of(curve());
  EXPECT_EQ(metrics.at("initial_inertial_number"), 1e-4);
  EXPECT_EQ(metrics.at("largest_inertial_number"), 0.5);
  EXPECT_NEAR(metrics.at("strain_when_not_quasi_static_over_peak"), 11.0 / 2.0, rounding);  // above 1e-3 from 11 % on
  Series slow = curve();
  for (std::size_t row = 0; row < slow.rows(); ++row) set(slow, "inertial_number", row, 1e-3);  // not above
  EXPECT_FALSE(metrics_of(slow).contains("strain_when_not_quasi_static_over_peak"));
}

TEST(CurveMetrics, WeighTheKineticStressWhileThereIsAnother) {
  EXPECT_NEAR(metrics_of(curve()).at("kinetic_share"), 5.0 / 1000.0, rounding);
  Series liquefied = curve();
  set(liquefied, "normal_stress", 18, 100.0);  // 1 % of sigma_0, not above
  EXPECT_NEAR(metrics_of(liquefied).at("kinetic_share"), 5.0 / 1050.0, rounding);
  set(liquefied, "normal_stress", 18, 0.0);
  EXPECT_NEAR(metrics_of(liquefied).at("kinetic_share"), 5.0 / 1050.0, rounding);
}

TEST(CurveMetrics, TellTheSuddenStartFromTheRest) {
  Series started = curve();
  set(started, "nicot_shear_stress", 0, 1000.0 - 300.0);  // at rest the shear stress is 1000 Pa
  EXPECT_NEAR(metrics_of(started).at("bagi_nicot_difference_at_start"), 300.0 / 3000.0, rounding);
  EXPECT_NEAR(metrics_of(started).at("bagi_nicot_difference"), 9.0 / 3000.0, rounding);
}

TEST(CurveMetrics, HoldTheFormulasAgainstEachOther) {
  EXPECT_NEAR(metrics_of(curve()).at("bagi_nicot_difference"), 9.0 / 3000.0, rounding);  // 9 Pa, at 7 %
  EXPECT_NEAR(metrics_of(curve(5)).at("bagi_nicot_difference"), 6.0 / 3000.0, rounding);
}

TEST(CurveMetrics, LeaveOutWhatAShortCurveDoesNotHave) {
  const auto metrics = metrics_of(curve(5));
  for (const char* name : {"mean_liquefied_normal", "mean_liquefied_shear", "lowest_normal", "regained_shear",
                           "regain_over_peak"})
    EXPECT_FALSE(metrics.contains(name)) << name;
  EXPECT_EQ(metrics.at("peak_shear_stress"), 3000.0);
  EXPECT_TRUE(metrics_of(curve(25)).contains("regained_shear"));
  EXPECT_FALSE(metrics_of(curve(24)).contains("regained_shear"));
}

TEST(CurveMetrics, LeaveOutWhatIsNotANumber) {
  // Dilates from the start, where the shear stress is 0: a regain of strength has no reference.
  Series dilating = curve();
  for (std::size_t row = 0; row < dilating.rows(); ++row)
    set(dilating, "normal_stress", row, 10e3 + 100.0 * static_cast<double>(row));
  set(dilating, "shear_stress", 0, 0.0);
  const auto metrics = metrics_of(dilating);
  EXPECT_FALSE(metrics.contains("regain_over_peak"));
  EXPECT_EQ(metrics.at("lowest_normal"), 1.0);
}

TEST(CurveMetrics, AreThoseThatTheClaimsAreAbout) {
  const auto metrics = metrics_of(curve());
  for (const Claim& claim : load_claims(FLOWSLIDE_CASE_FOLDER "/claims.toml").claims) {
    if (claim.metric == "rate_effect") continue;  // of two points, see UndrainedCase::compare
    const std::string ending = ".median", curve_and_name = claim.metric.substr(0, claim.metric.size() - ending.size());
    EXPECT_TRUE(claim.metric.ends_with(ending)) << claim.id << " is about one replicate: " << claim.metric;
    const std::string name = curve_and_name.substr(curve_and_name.find('.') + 1);
    EXPECT_TRUE(metrics.contains(name)) << claim.id << " is about " << claim.metric;
  }
}

}  // namespace
}  // namespace flowslide
