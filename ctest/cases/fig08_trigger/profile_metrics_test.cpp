// SPDX-License-Identifier: GPL-2.0-or-later
#include "profile_metrics.hpp"

#include <gtest/gtest.h>

#include <map>

namespace flowslide {
namespace {

Series profiles(std::vector<double> shear, std::vector<double> normal) {
  Series series;
  series.axis.values = {0.05, 0.15, 0.25, 0.35, 0.45, 0.55, 0.65, 0.75, 0.85, 0.95};
  series.columns = {{"velocity_1", "v", "1", "velocity", "", series.axis.values},
                    {"shear_stress_1", "tau", "1", "shear stress", "", std::move(shear)},
                    {"normal_stress_1", "sigma", "1", "normal stress", "", std::move(normal)}};
  return series;
}

std::map<std::string, double> metrics_of(const Series& series) {
  std::map<std::string, double> values;
  for (const Metric& metric : profile_metrics(series)) values[metric.name] = metric.value;
  return values;
}

TEST(ProfileMetrics, LeaveOutTheSublayersBehindTheGluedGrains) {
  const auto metrics = metrics_of(profiles({9.0, 0.5, 0.6, 0.7, 1.0, 1.0, 1.2, 1.3, 1.4, 9.0},
                                           {0.1, 1.0, 1.0, 1.0, 1.1, 1.0, 0.9, 1.0, 1.0, 0.1}));
  EXPECT_NEAR(metrics.at("shear_top_1"), 1.3, 1e-12);
  EXPECT_NEAR(metrics.at("shear_bottom_1"), 0.6, 1e-12);
  EXPECT_NEAR(metrics.at("normal_unevenness_1"), 0.1, 1e-12);
  EXPECT_NEAR(metrics.at("linearity_1"), 1.0, 1e-12);
}

TEST(ProfileMetrics, AreThoseOfTheMeanAndOfTheFirstSnapshot) {
  Series series = profiles(std::vector<double>(10, 1.0), std::vector<double>(10, 1.0));
  Series snapshot = profiles(std::vector<double>(10, 2.0), {0.1, 1.0, 1.0, 1.0, 1.4, 1.0, 0.6, 1.0, 1.0, 0.1});
  for (Column& column : snapshot.columns) {
    column.name = "snapshot_" + column.name;
    series.columns.push_back(column);
  }
  const auto metrics = metrics_of(series);
  EXPECT_EQ(metrics.size(), 8U);
  EXPECT_NEAR(metrics.at("shear_top_1"), 1.0, 1e-12);
  EXPECT_NEAR(metrics.at("normal_unevenness_1"), 0.0, 1e-12);
  EXPECT_NEAR(metrics.at("snapshot_shear_top_1"), 2.0, 1e-12);
  EXPECT_NEAR(metrics.at("snapshot_normal_unevenness_1"), 0.4, 1e-12);
}

TEST(ProfileMetrics, AreNoneWithoutProfiles) { EXPECT_TRUE(profile_metrics(Series{}).empty()); }

}  // namespace
}  // namespace flowslide
