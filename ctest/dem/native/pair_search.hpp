// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <vector>

#include "dem/native/cell_grid.hpp"
#include "support/clustered_cloud.hpp"

namespace flowslide::native {

/// The grains as the native engine holds them, with the two that pad tiles.
inline std::vector<Body> bodies_of(const Assembly& assembly) {
  std::vector<Body> bodies(assembly.size() + 2, Body{});
  for (std::size_t i = 0; i < assembly.size(); ++i) {
    Vector3::Map(bodies[i].position) = assembly.position[i];
    Vector3::Map(bodies[i].velocity) = assembly.velocity[i];
    bodies[i].radius = assembly.radius[i];
    bodies[i].mass = 1e4 * assembly.radius[i] * assembly.radius[i] * assembly.radius[i];
  }
  bodies[assembly.size() + 1].position[0] = 1.0;
  for (std::size_t i = assembly.size(); i < bodies.size(); ++i) bodies[i].radius = bodies[i].mass = 1e-3;
  return bodies;
}

/// All later neighbours of a grain with all their images, by looking at every one.
inline std::vector<Neighbour> every_later_neighbour(const Assembly& a, std::uint32_t i, double skin) {
  std::vector<Neighbour> found;
  const auto reach = [&](int axis) { return a.cell.periodic[axis] ? 1 : 0; };
  for (std::uint32_t j = i + 1; j < a.size(); ++j)
    for (int x = -reach(0); x <= reach(0); ++x)
      for (int y = -reach(1); y <= reach(1); ++y)
        for (int z = -reach(2); z <= reach(2); ++z) {
          const Vector3 d = a.position[i] - a.position[j] - Vector3(x, y, z).cwiseProduct(a.cell.lengths());
          const double near = a.radius[i] + a.radius[j] + skin;
          if (d.squaredNorm() < near * near) found.push_back({j, image_of(x, y, z)});
        }
  return found;
}

/// One of many small random clouds: 1 to 24 grains, radii to 1:3, each axis rigid or periodic, some grains glued.
inline Assembly fuzzed_cloud(std::uint64_t seed) {
  Dice dice(seed ^ 0x9e3779b97f4a7c15u);
  CloudShape shape;
  shape.grains = 1 + dice.below(24);
  shape.largest = 3e-3;
  shape.smallest = dice.between(1e-3, 3e-3);
  shape.overlap = dice.between(0.001, 0.02);
  Cell cell;
  cell.lower = dice.vector(0.02);
  for (int axis = 0; axis < 3; ++axis) {
    cell.periodic[axis] = dice.below(2) == 0;
    cell.upper[axis] = cell.lower[axis] + dice.between(0.0135, 0.04);  // from two reaches of the largest on
  }
  Assembly cloud = clustered_cloud(seed, cell, shape);
  if (dice.below(3) == 0)
    for (std::size_t i = 0; i < cloud.size(); ++i) cloud.role[i] = static_cast<Role>(dice.below(3));
  return cloud;
}

}  // namespace flowslide::native
