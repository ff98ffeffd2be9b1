// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <array>
#include <cstdint>
#include <random>

#include "grains/assembly.hpp"

namespace flowslide::testing {

inline double uniform(std::mt19937_64& generator, double low, double high) {
  return low + (high - low) * static_cast<double>(generator() >> 11) * 0x1.0p-53;
}

inline Vector3 uniform_vector(std::mt19937_64& generator, double largest) {
  const double x = uniform(generator, -largest, largest), y = uniform(generator, -largest, largest);
  return {x, y, uniform(generator, -largest, largest)};
}

/// `count` mobile grains with diameters of 5 to 7.5 mm anywhere in a cell of the given lengths (m) whose lower corner
/// is off the origin; with velocities, spins, forces and torques. Overlaps are of any size.
inline Assembly random_cloud(std::uint64_t seed, std::size_t count, const Vector3& lengths,
                             std::array<bool, 3> periodic) {
  std::mt19937_64 generator(seed);
  Assembly assembly;
  assembly.resize(count);
  assembly.cell.lower = Vector3(0.01, -0.02, 0.03);
  assembly.cell.upper = assembly.cell.lower + lengths;
  assembly.cell.periodic = periodic;
  for (std::size_t i = 0; i < count; ++i) {
    assembly.radius[i] = uniform(generator, 2.5e-3, 3.75e-3);
    for (int axis = 0; axis < 3; ++axis)
      assembly.position[i][axis] = uniform(generator, assembly.cell.lower[axis], assembly.cell.upper[axis]);
    assembly.velocity[i] = uniform_vector(generator, 0.1);
    assembly.spin[i] = uniform_vector(generator, 10.0);
    assembly.force[i] = uniform_vector(generator, 1.0);
    assembly.torque[i] = uniform_vector(generator, 1e-3);
  }
  return assembly;
}

/// Grains whose centre is within `thickness` (m) of the bottom or the top are glued, at rest and without spin.
inline void glue_layers(Assembly& assembly, double thickness) {
  for (std::size_t i = 0; i < assembly.size(); ++i) {
    const double z = assembly.position[i].z();
    if (z < assembly.cell.lower.z() + thickness) assembly.role[i] = Role::bottom_layer;
    if (z > assembly.cell.upper.z() - thickness) assembly.role[i] = Role::top_layer;
    if (assembly.role[i] == Role::mobile) continue;
    assembly.velocity[i] = assembly.spin[i] = Vector3::Zero();
  }
}

}  // namespace flowslide::testing
