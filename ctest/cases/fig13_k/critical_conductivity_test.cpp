// SPDX-License-Identifier: GPL-2.0-or-later
#include "critical_conductivity.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace flowslide {
namespace {

constexpr double rounding = 1e-12;

/// Replicates with these velocities after the pulse, which are also their largest, m/s. 0: sliding has stopped.
Ensemble samples(double k, const std::vector<double>& velocities) {
  Ensemble all(velocities.size());
  for (std::size_t i = 0; i < velocities.size(); ++i) {
    all[i].provenance.replicate = static_cast<int>(i);
    all[i].parameters = {{"hydraulic_conductivity", k, "m/s", ""}};
    all[i].metrics = {{"stands", velocities[i] > 0.0 ? 0.0 : 1.0, "1", ""},
                      {"velocity_after_pulse", velocities[i], "m/s", ""},
                      {"largest_velocity", velocities[i], "m/s", ""},
                      {"runout", 2.0 * velocities[i], "m", ""}};
  }
  return all;
}

TEST(CriticalConductivity, LiesBetweenNoChangeAndChange) {
  const Ensembles slides{{"RI_0", samples(0, {2.0, 1.0})},
                         {"RI_1e-5", samples(1e-5, {1.9, 0.95})},
                         {"RI_2e-5", samples(2e-5, {2.1, 0.4})},
                         {"RI_mine", samples(4e-5, {0.5, 0.2})},  // k is read from the parameter, not from the name
                         {"RI_1e-4", samples(1e-4, {0.0, 0.0})}};
  const auto sweep = sweep_of(slides, "RI_", "hydraulic_conductivity");
  EXPECT_EQ(critical_conductivity(sweep, slides.at("RI_0")[0]).lower, 2e-5);
  EXPECT_EQ(critical_conductivity(sweep, slides.at("RI_0")[0]).upper, 4e-5);
  EXPECT_EQ(critical_conductivity(sweep, slides.at("RI_0")[1]).lower, 1e-5);
  EXPECT_EQ(critical_conductivity(sweep, slides.at("RI_0")[1]).upper, 2e-5);
  std::map<std::string, double> metrics;
  compare_conductivities(slides, metrics);
  EXPECT_NEAR(metrics.at("critical_conductivity"), 0.5 * (std::sqrt(8e-10) + std::sqrt(2e-10)), rounding);
  EXPECT_EQ(metrics.at("critical_conductivity_lower"), 1e-5);
  EXPECT_EQ(metrics.at("critical_conductivity_upper"), 4e-5);
  EXPECT_NEAR(metrics.at("RI_change_below"), 1.0 / 6.0, rounding);  // of the medians: 1.5 to 1.25 at 2e-5
  EXPECT_EQ(metrics.at("RI_stopped_above"), 0.0);  // at 4e-5 both still slide
  const Series series = critical_series(slides);
  EXPECT_EQ(series.column("lower").values, std::vector<double>{1e-5});
  EXPECT_EQ(series.column("upper").values, std::vector<double>{4e-5});
}

TEST(CriticalConductivity, CountsSamplesThatStandAtOnceAndThoseThatNothingStops) {
  const Ensembles slides{{"RI_0", samples(0, {2.0, 2.0, 2.0})},
                         {"RI_1e-5", samples(1e-5, {0.1, 2.0, 2.0})},
                         {"RI_4e-5", samples(4e-5, {0.0, 0.1, 2.0})}};
  std::map<std::string, double> metrics;
  compare_conductivities(slides, metrics);
  EXPECT_NEAR(metrics.at("critical_conductivity"), 2e-5, rounding);  // of 0, 2e-5 and infinity
  EXPECT_EQ(metrics.at("critical_conductivity_lower"), 0.0);
  EXPECT_TRUE(std::isnan(metrics.at("RI_stopped_above")));  // no k is above all of them
  EXPECT_EQ(critical_series(slides).rows(), 0U);
}

TEST(CriticalConductivity, IsWideWhereTheOrderIsMixed) {
  const Ensembles slides{{"RI_0", samples(0, {1.0})},
                         {"RI_1e-5", samples(1e-5, {1.0})},
                         {"RI_2e-5", samples(2e-5, {0.4})},
                         {"RI_4e-5", samples(4e-5, {1.0})},
                         {"RI_1e-4", samples(1e-4, {0.0})}};
  const auto critical = critical_conductivity(sweep_of(slides, "RI_", "hydraulic_conductivity"), Result{});
  EXPECT_EQ(critical.lower, 1e-5);
  EXPECT_EQ(critical.upper, 1e-4);
}

TEST(CriticalConductivity, IsUnknownIfNothingChangesOrNothingIsUndrained) {
  const Ensembles alike{{"RI_0", samples(0, {2.0})}, {"RI_1e-5", samples(1e-5, {2.0})}};
  EXPECT_TRUE(std::isnan(critical_conductivity(sweep_of(alike, "RI_", "hydraulic_conductivity"), Result{}).upper));
  const Ensembles drained{{"RI_1e-5", samples(1e-5, {2.0})}, {"RI_1e-4", samples(1e-4, {0.0})}};
  EXPECT_TRUE(std::isnan(critical_conductivity(sweep_of(drained, "RI_", "hydraulic_conductivity"), Result{}).lower));
  EXPECT_TRUE(std::isnan(critical_conductivity({}, Result{}).lower));
  EXPECT_EQ(critical_series(alike).rows(), 0U);
}

TEST(CompareConductivities, TellsTheOrderOfRD) {
  const Ensembles slides{{"RD_0", samples(0, {2.0})},
                         {"RD_1e-5", samples(1e-5, {1.5})},
                         {"RD_4e-5", samples(4e-5, {1.6})},
                         {"RD_1e-4", samples(1e-4, {1.0})}};
  std::map<std::string, double> metrics;
  compare_conductivities(slides, metrics);
  EXPECT_NEAR(metrics.at("RD_velocity_order"), -0.8, rounding);  // two neighbours exchanged: 1 - 6 x 2/60
  EXPECT_NEAR(metrics.at("RD_runout_order"), -0.8, rounding);
  EXPECT_FALSE(metrics.contains("critical_conductivity"));
}

}  // namespace
}  // namespace flowslide
