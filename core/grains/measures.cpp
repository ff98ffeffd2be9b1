// SPDX-License-Identifier: GPL-2.0-or-later
#include "grains/measures.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "grains/pair_constants.hpp"
#include "grains/require.hpp"

namespace flowslide {
namespace {

/// sqrt(rho / p) D, s: the inertial number is this time multiplied by the shear rate.
double inertial_time(double mean_diameter, double density, double pressure) {
  require(mean_diameter > 0.0, "mean diameter", mean_diameter, "> 0 m", "Is the assembly empty?");
  require(density > 0.0, "density", density, "> 0 kg/m^3", "Give the density of the solid.");
  require(pressure > 0.0, "pressure", pressure, "> 0 Pa",
          "Without pressure the inertial number has no value: set a floor for the pressure.");
  return mean_diameter * std::sqrt(density / pressure);
}

}  // namespace

double void_ratio(const Assembly& assembly) {
  const double solid = assembly.solid_volume();
  require(solid > 0.0, "solid volume", solid, "> 0 m^3", "The assembly holds no grain.");
  return (assembly.cell.volume() - solid) / solid;
}

double volume_below(double radius, double height) {
  // Spherical cap of the depth h = R + height: pi h^2 (3 R - h) / 3.
  const double depth = std::clamp(radius + height, 0.0, 2.0 * radius);
  return std::numbers::pi * depth * depth * (3.0 * radius - depth) / 3.0;
}

double void_ratio_of_bulk(const Assembly& assembly, double margin) {
  const Cell& cell = assembly.cell;
  require(margin >= 0.0 && 2.0 * margin < cell.height(), "margin", margin,
          fmt::format("0 to less than half of the height, {} m", 0.5 * cell.height()), "Use a smaller margin.");
  const double bottom = cell.lower.z() + margin, top = cell.upper.z() - margin;
  double solid = 0.0;
  for (std::size_t i = 0; i < assembly.size(); ++i) {
    const double z = assembly.position[i].z();
    solid += volume_below(assembly.radius[i], top - z) - volume_below(assembly.radius[i], bottom - z);
  }
  require(solid > 0.0, "solid volume", solid, "> 0 m^3", "No grain lies between the planes: use a smaller margin.");
  return (cell.area() * (top - bottom) - solid) / solid;
}

double probe_void_ratio(const Assembly& assembly) {
  constexpr double outer_share = 0.075;
  return void_ratio_of_bulk(assembly, outer_share * assembly.cell.height());
}

double inertial_number(double shear_rate, double mean_diameter, double density, double pressure) {
  return shear_rate * inertial_time(mean_diameter, density, pressure);
}

double shear_rate_for(double inertial_number, double mean_diameter, double density, double pressure) {
  return inertial_number / inertial_time(mean_diameter, density, pressure);
}

double rayleigh_time(double radius, const Material& material) {
  return std::numbers::pi * radius * std::sqrt(material.density / material.shear_modulus()) /
         (0.1631 * material.poisson_ratio + 0.8766);
}

double hertz_impact_overlap(double radius, const Material& material, double impact_speed) {
  require(impact_speed > 0.0, "impact speed", impact_speed, "> 0 m/s", "Give the relative speed of approach.");
  const PairConstants pair = pair_constants(material, radius, radius);
  const double energy = pair.effective_mass * impact_speed * impact_speed;
  return std::pow(15.0 * energy / (16.0 * pair.effective_modulus * std::sqrt(pair.effective_radius)), 0.4);
}

}  // namespace flowslide
