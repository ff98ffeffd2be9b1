// SPDX-License-Identifier: GPL-2.0-or-later
// The energy of grains, and clouds that start with the forces of their state.
#pragma once
#include <cmath>
#include <utility>

#include "grains/contact_forces.hpp"
#include "grains/contact_search.hpp"
#include "grains/pair_constants.hpp"

namespace flowslide {

/// Motion and normal springs, J: U = 8/15 Y* sqrt(R*) overlap^(5/2).
inline double energy(const Assembly& a) {
  const Material m;
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    sum += 0.5 * sphere_mass(a.radius[i], m) * a.velocity[i].squaredNorm() +
           0.5 * sphere_inertia(a.radius[i], m) * a.spin[i].squaredNorm();
  for (const TouchingPair& pair : touching_pairs(a)) {
    const PairConstants c = pair_constants(m, a.radius[pair.first], a.radius[pair.second]);
    const double distance = a.cell.nearest_image(a.position[pair.first] - a.position[pair.second]).norm();
    sum += 8.0 / 15.0 * c.effective_modulus * std::sqrt(c.effective_radius) *
           std::pow(c.radius_first + c.radius_second - distance, 2.5);
  }
  return sum;
}

inline Material frictionless(double restitution) {
  Material m;
  m.restitution = restitution;
  m.sliding_friction = m.rolling_friction = 0.0;
  return m;
}

/// A cloud that starts with the forces of its state, so that the first half kick is there.
inline Assembly with_forces(Assembly cloud, const Material& m) {
  const GrainForces forces = sum_on_grains(evaluate_contact_forces(cloud, m, 0.0), cloud.size());
  cloud.force = forces.force;
  cloud.torque = forces.torque;
  return cloud;
}

}  // namespace flowslide
