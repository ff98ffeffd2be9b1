// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <random>

#include "grains/assembly.hpp"

namespace flowslide {

/// A small sample that needs no preparation: `side` x `side` x `layers` spheres of about 6 mm on a simple cubic lattice
/// with overlaps of some 0.2 % of a diameter, a little disorder and slow random motion, periodic in x and y; the first
/// and the last layer are glued. It carries stress, and its contacts slide and roll when it is sheared.
inline Assembly touching_lattice(int side = 6, int layers = 7, unsigned seed = 1) {
  constexpr double diameter = 6e-3, spacing = 0.998 * diameter;
  std::mt19937_64 random(seed);
  const auto noise = [&](double size) {
    return size * (2.0 * static_cast<double>(random() >> 11) / 9007199254740992.0 - 1.0);
  };
  Assembly assembly;
  assembly.cell.upper = {side * spacing, side * spacing, layers * spacing};
  assembly.cell.periodic = {true, true, false};
  assembly.resize(static_cast<std::size_t>(side) * side * layers);
  std::size_t i = 0;
  for (int z = 0; z < layers; ++z)
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x, ++i) {
        const bool bottom = z == 0, top = z == layers - 1;
        assembly.radius[i] = 0.5 * diameter * (1.0 + noise(5e-4));
        assembly.position[i] = spacing * Vector3(x + 0.5, y + 0.5, z + 0.5);
        assembly.role[i] = bottom ? Role::bottom_layer : top ? Role::top_layer : Role::mobile;
        if (bottom || top) continue;
        for (int axis = 0; axis < 3; ++axis) {
          assembly.position[i][axis] += noise(1e-3 * diameter);
          assembly.velocity[i][axis] = noise(1e-3);
          assembly.spin[i][axis] = noise(1.0);
        }
      }
  return assembly;
}

}  // namespace flowslide
