// SPDX-License-Identifier: GPL-2.0-or-later
#include "point_metrics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

#include "experiment/shear_test.hpp"
#include "experiment/slide_run.hpp"
#include "grains/measures.hpp"

namespace flowslide {
namespace {

std::map<std::string, double> by_name(const std::vector<Metric>& metrics) {
  std::map<std::string, double> values;
  for (const Metric& metric : metrics) values[metric.name] = metric.value;
  return values;
}

std::size_t index_of(const Series& series, const std::string& name) {
  for (std::size_t i = 0; i < series.columns.size(); ++i)
    if (series.columns[i].name == name) return i;
  throw std::out_of_range(name);
}

/// Rows of an empty record whose strain grows by `step`, with columns as functions of the strain.
template <typename... Columns>
Series record(Series series, double step, int rows, Columns... columns) {
  for (int row = 0; row <= rows; ++row) {
    std::vector<double> values(series.columns.size(), 0.0);
    const double strain = step * row;
    values[index_of(series, "shear_strain")] = strain;
    ((values[index_of(series, columns.first)] = columns.second(strain)), ...);
    series.append_row(0.1 * row, values);
  }
  return series;
}

template <typename Function>
std::pair<const char*, Function> column(const char* name, Function function) {
  return {name, function};
}

TEST(PointMetrics, FrictionOfAHeldSlopeIsThatOfTheMeansBeyondHalfAStrain) {
  const Series series = record(
      slide_series(), 1e-2, 150, column("shear_stress", [](double strain) { return strain < 0.5 ? 4000.0 : 300.0; }),
      column("normal_stress", [](double strain) { return strain < 0.5 ? 28e3 : strain < 1.0 ? 500.0 : 1000.0; }),
      column("velocity", [](double strain) { return 2.0 * strain; }));
  const auto metrics = by_name(held_metrics(measures_of_rows(series), {}, series.last("velocity")));
  EXPECT_NEAR(metrics.at("steady_friction"), 0.4, 5e-3);  // 300/750, but for the rows beside the jumps
  EXPECT_DOUBLE_EQ(metrics.at("final_velocity"), 3.0);
  EXPECT_EQ(metrics.size(), 2u);  // no profiles, no linearity
}

TEST(PointMetrics, HaveTheLinearityOfEachProfileWhateverStandsBesideIt) {
  // Columns of ProfileRecord with several snapshots: what is read, and the other of first snapshot and mean.
  Series profiles;
  profiles.axis = {"relative_height", "z/H", "1", "height", "", {0.25, 0.5, 0.75}};
  for (const char* number : {"1", "2"})
    for (const char* of : {"", "mean_"})
      for (const char* what : {"velocity_", "shear_stress_", "normal_stress_"})
        profiles.columns.push_back({std::string(of) + what + number, "", "1", "", "", {0.2, 0.5, 0.8}});
  const Series series = record(slide_series(), 1e-2, 150, column("normal_stress", [](double) { return 1e3; }));
  const auto metrics = by_name(held_metrics(measures_of_rows(series), profiles, 1.0));
  EXPECT_NEAR(metrics.at("linearity_1"), 1.0, 1e-12);
  EXPECT_NEAR(metrics.at("linearity_2"), 1.0, 1e-12);
  EXPECT_EQ(metrics.size(), 4u);
}

TEST(PointMetrics, SteadyFlowCountsBeyondAStrainOfOneWithItsKineticPart) {
  const Series series = record(shear_test_series(), 1e-2, 300,
                               column("shear_stress", [](double strain) { return strain < 0.995 ? 500.0 : 380.0; }),
                               column("kinetic_shear_stress", [](double) { return 20.0; }),
                               column("normal_stress", [](double strain) { return strain < 0.995 ? 700.0 : 900.0; }),
                               column("kinetic_normal_stress", [](double) { return 100.0; }),
                               column("mean_stress", [](double) { return 800.0; }));
  const auto metrics = by_name(flow_metrics(series, 10.0, 6e-3, 2650.0));
  EXPECT_NEAR(metrics.at("friction"), 0.4, 1e-12);
  EXPECT_NEAR(metrics.at("inertial_number"), inertial_number(10.0, 6e-3, 2650.0, 800.0), 1e-12);
  const Series young = record(shear_test_series(), 1e-2, 50, column("mean_stress", [](double) { return 800.0; }));
  const auto none = by_name(flow_metrics(young, 10.0, 6e-3, 2650.0));
  EXPECT_TRUE(std::isnan(none.at("friction")));
  EXPECT_TRUE(std::isnan(none.at("inertial_number")));
}

TEST(PointMetrics, FrequenciesOfAProbeAreThoseOfItsModulus) {
  const Series series = record(shear_test_series(), 1e-5, 10,
                               column("shear_stress", [](double strain) { return 2650.0 + 15e6 * strain; }));
  SlopeProperties slope;
  slope.liquefiable_thickness = 0.2;
  const auto held = by_name(probe_metrics(series, {0.13, 1500.0, false}, slope));
  EXPECT_NEAR(held.at("shear_modulus"), 15e6, 1.0);
  EXPECT_NEAR(held.at("shear_wave_speed"), 100.0, 1e-5);
  EXPECT_NEAR(held.at("sample_frequency"), 100.0 / 0.26, 1e-4);
  const double slow = std::sqrt(15e6 / (0.2 * mass_per_area(slope))) / (2.0 * std::numbers::pi);
  EXPECT_NEAR(held.at("slope_frequency"), slow, 1e-5 * slow);
  EXPECT_NEAR(held.at("frequency_ratio"), held.at("sample_frequency") / slow, 1e-5);
  const auto periodic = by_name(probe_metrics(series, {0.13, 1500.0, true}, slope));
  EXPECT_NEAR(periodic.at("sample_frequency"), 2.0 * held.at("sample_frequency"), 1e-9);
}

}  // namespace
}  // namespace flowslide
