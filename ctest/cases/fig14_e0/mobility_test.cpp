// SPDX-License-Identifier: GPL-2.0-or-later
#include "mobility.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace flowslide {
namespace {

constexpr double rounding = 1e-12;

/// Replicates with these velocities, and half of them as runout.
Ensemble replicates(const std::vector<double>& velocities) {
  Ensemble all(velocities.size());
  for (std::size_t i = 0; i < velocities.size(); ++i) {
    all[i].provenance.replicate = static_cast<int>(i);
    all[i].metrics = {{"largest_velocity", velocities[i], "m/s", ""}, {"runout", 0.5 * velocities[i], "m", ""}};
  }
  return all;
}

TEST(Mobility, ComparesVoidRatiosByMediansAndSchemesOnTheSameSamples) {
  std::map<std::string, double> metrics;
  compare_void_ratios({{"RD_e0_790", replicates({1.0, 2.0, 9.0})},
                       {"RI_e0_790", replicates({4.0})},
                       {"RD_e0_771", replicates({0.5, 0.1, 0.9})},
                       {"RI_e0_771", replicates({3.8, 3.0, 4.4})}},
                      metrics);
  EXPECT_NEAR(metrics.at("RD_771_velocity_share"), 0.25, rounding);
  EXPECT_NEAR(metrics.at("RI_771_velocity_share"), 0.95, rounding);
  EXPECT_NEAR(metrics.at("RI_771_runout_share"), 0.95, rounding);
  EXPECT_NEAR(metrics.at("RD_790_velocity_over_RI"), 0.25, rounding);  // on the one sample that both use
  EXPECT_NEAR(metrics.at("RD_771_runout_over_RI"), 0.5 / 3.8, rounding);
  EXPECT_NEAR(metrics.at("771_largest_runout"), 2.2, rounding);
  EXPECT_NEAR(metrics.at("771_runout_difference"), 0.5 * (4.4 - 0.9), rounding);
}

TEST(Mobility, SaysNothingOfWhatWasNotRun) {
  std::map<std::string, double> metrics;
  compare_void_ratios({{"RD_e0_771", replicates({0.5})}}, metrics);
  EXPECT_TRUE(std::isnan(metrics.at("RD_771_velocity_share")));
  EXPECT_TRUE(std::isnan(metrics.at("RD_771_runout_over_RI")));
  EXPECT_TRUE(std::isnan(metrics.at("771_runout_difference")));
  EXPECT_TRUE(std::isnan(metrics.at("751_largest_runout")));
  EXPECT_EQ(metrics.at("771_largest_runout"), 0.25);
}

}  // namespace
}  // namespace flowslide
