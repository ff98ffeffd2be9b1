// SPDX-License-Identifier: GPL-2.0-or-later
#include "point_metrics.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "experiment/ensemble.hpp"
#include "experiment/profile_record.hpp"
#include "grains/measures.hpp"

namespace flowslide {
namespace {

/// Slope of the least-squares line of y over x.
double slope_of(const std::vector<double>& x, const std::vector<double>& y) {
  double x_mean = 0.0, y_mean = 0.0, xx = 0.0, xy = 0.0;
  const auto share = 1.0 / static_cast<double>(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    x_mean += share * x[i];
    y_mean += share * y[i];
  }
  for (std::size_t i = 0; i < x.size(); ++i) {
    xx += (x[i] - x_mean) * (x[i] - x_mean);
    xy += (x[i] - x_mean) * (y[i] - y_mean);
  }
  return xy / xx;
}

}  // namespace

std::vector<Metric> held_metrics(const RunMeasures& measures, const Series& profiles, double final_velocity) {
  const auto steady = [&](const char* column) {
    return mean_over(measures.over_strain, column, steady_strain, std::numeric_limits<double>::infinity());
  };
  std::vector<Metric> metrics{{"steady_friction", steady("shear_stress") / steady("normal_stress"), "1",
                               "mu_ss, mean tau over mean sigma beyond 50 % strain"},
                              {"final_velocity", final_velocity, "m/s", "sliding velocity at the end"}};
  for (std::size_t i = 1; profiles.has(fmt::format("velocity_{}", i)); ++i)
    metrics.push_back({fmt::format("linearity_{}", i), linearity(profiles, fmt::format("velocity_{}", i)), "1",
                       "R^2 of a straight line through the velocity profile"});
  return metrics;
}

std::vector<Metric> flow_metrics(const Series& series, double shear_rate, double mean_diameter, double density) {
  const auto steady = [&](const char* column) {
    return mean_between(series, column, "shear_strain", steady_flow_strain, std::numeric_limits<double>::infinity());
  };
  const double shear = steady("shear_stress") + steady("kinetic_shear_stress");
  const double normal = steady("normal_stress") + steady("kinetic_normal_stress"), mean = steady("mean_stress");
  const double number = mean > 0.0 ? inertial_number(shear_rate, mean_diameter, density, mean)
                                   : std::numeric_limits<double>::quiet_NaN();
  return {{"shear_rate", shear_rate, "1/s", "shear rate"},
          {"steady_shear", shear, "Pa", "mean shear stress beyond a strain of 1"},
          {"steady_normal", normal, "Pa", "mean normal stress beyond a strain of 1"},
          {"steady_mean", mean, "Pa", "mean of p beyond a strain of 1"},
          {"inertial_number", number, "1", "inertial number with the mean of p"},
          {"friction", shear / normal, "1", "shear over normal stress"}};
}

std::vector<Metric> probe_metrics(const Series& series, const Body& sample, const SlopeProperties& slope) {
  const double modulus = slope_of(series.column("shear_strain").values, series.column("shear_stress").values);
  const double speed = std::sqrt(modulus / sample.density), wave = (sample.periodic ? 1.0 : 2.0) * sample.height;
  const double inertia = slope.liquefiable_thickness * mass_per_area(slope);
  const double ratio = 2.0 * std::numbers::pi * std::sqrt(inertia / sample.density) / wave;
  return {{"shear_modulus", modulus, "Pa", "shear modulus of the first strain"},
          {"shear_wave_speed", speed, "m/s", "speed of shear waves in the sample"},
          {"sample_frequency", speed / wave, "Hz", "natural frequency of the sample in shear"},
          {"slope_frequency", speed / wave / ratio, "Hz", "natural frequency of the slope on the sample"},
          {"frequency_ratio", ratio, "1", "natural frequency of the sample over the slope's"}};
}

}  // namespace flowslide
