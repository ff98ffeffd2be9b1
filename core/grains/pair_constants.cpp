// SPDX-License-Identifier: GPL-2.0-or-later
#include "grains/pair_constants.hpp"

#include <cmath>
#include <numbers>

#include "grains/material.hpp"

namespace flowslide {
namespace {

double square(double x) { return x * x; }

double damping_ratio(double restitution) {
  const double log_restitution = std::log(restitution);
  return log_restitution / std::sqrt(square(log_restitution) + square(std::numbers::pi));
}

PairConstants moduli(const Material& material) {
  const double nu = material.poisson_ratio;
  PairConstants constants;
  constants.effective_modulus = material.youngs_modulus / (2.0 * (1.0 - square(nu)));
  constants.effective_shear_modulus = material.youngs_modulus / (4.0 * (2.0 - nu) * (1.0 + nu));
  constants.damping = damping_ratio(material.restitution);
  return constants;
}

}  // namespace

double sphere_mass(double radius, const Material& material) {
  return 4.0 / 3.0 * std::numbers::pi * radius * radius * radius * material.density;
}

double sphere_inertia(double radius, const Material& material) {
  return 0.4 * sphere_mass(radius, material) * square(radius);
}

PairConstants pair_constants(const Material& material, double radius_first, double radius_second) {
  PairConstants pair = moduli(material);
  pair.radius_first = radius_first;
  pair.radius_second = radius_second;
  pair.effective_radius = radius_first * radius_second / (radius_first + radius_second);
  const double mass_first = sphere_mass(radius_first, material);
  const double mass_second = sphere_mass(radius_second, material);
  pair.effective_mass = mass_first * mass_second / (mass_first + mass_second);
  const double inertia_first = mass_first * square(radius_first);
  const double inertia_second = mass_second * square(radius_second);
  pair.rolling_inertia = 1.4 * inertia_first * inertia_second / (inertia_first + inertia_second);
  return pair;
}

PairConstants plane_constants(const Material& material, double radius) {
  PairConstants pair = moduli(material);
  pair.radius_first = radius;
  pair.effective_radius = radius;
  pair.effective_mass = sphere_mass(radius, material);
  pair.rolling_inertia = 1.4 * pair.effective_mass * square(radius);
  return pair;
}

}  // namespace flowslide
