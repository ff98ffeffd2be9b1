// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <vector>

#include "dem/native/cell_grid.hpp"
#include "grains/contact_search.hpp"
#include "grains/material.hpp"
#include "grains/pair_constants.hpp"
#include "support/clustered_cloud.hpp"

namespace flowslide::native {

/// The grains as the native engine holds them, with the two that pad tiles.
template <typename Real = double>
std::vector<Body<Real>> bodies_of(const Assembly& assembly) {
  std::vector<Body<Real>> bodies;
  for (std::size_t i = 0; i < assembly.size() + 2; ++i) {
    Body<double> body{};
    body.radius = body.mass = body.inertia = 1e-3;
    if (i < assembly.size()) {
      Vector3::Map(body.position) = assembly.position[i];
      Vector3::Map(body.velocity) = assembly.velocity[i];
      Vector3::Map(body.spin) = assembly.spin[i];
      body.radius = assembly.radius[i];
      body.mass = sphere_mass(body.radius, Material{});
      body.inertia = sphere_inertia(body.radius, Material{});
    } else {
      body.position[0] = static_cast<double>(i - assembly.size());  // 1 m apart
    }
    bodies.push_back(in_precision<Real>(body));
  }
  return bodies;
}

/// Allowances (m) of some grains at rest and some fast ones.
inline std::vector<double> some_allowances(std::size_t grains, Dice& dice) {
  const double at_rest = dice.between(0.0, 1e-4);
  std::vector<double> allowance(grains);
  for (double& a : allowance) a = at_rest + (dice.below(4) == 0 ? dice.between(0.0, 2.5e-4) : 0.0);
  return allowance;
}

/// All pairs of a range with all their images, by looking at every one.
inline std::vector<NearPair> every_near_pair(const Assembly& a, const std::vector<double>& allowance,
                                             const GrainRange& range) {
  std::vector<NearPair> found;
  const auto reach = [&](int axis) { return a.cell.periodic[axis] ? 1 : 0; };
  for (std::uint32_t i = 0; i < a.size(); ++i)
    for (std::uint32_t j = i + 1; j < a.size(); ++j) {
      if (!range.owns(i) && !range.owns(j)) continue;
      for (int x = -reach(0); x <= reach(0); ++x)
        for (int y = -reach(1); y <= reach(1); ++y)
          for (int z = -reach(2); z <= reach(2); ++z) {
            const Vector3 shift = Vector3(x, y, z).cwiseProduct(a.cell.lengths()) +
                                  z * a.cell.shear_offset * Vector3::UnitX();
            const Vector3 d = a.position[i] - a.position[j] - shift;
            const double near = (a.radius[i] + allowance[i]) + (a.radius[j] + allowance[j]);
            if (d.squaredNorm() < near * near) found.push_back({i, j, image_of(x, y, z)});
          }
    }
  return found;
}

/// Pairs that touch, by looking at every one.
inline std::vector<TouchingPair> every_touching_pair(const Assembly& a) {
  std::vector<TouchingPair> pairs;
  for (std::uint32_t i = 0; i < a.size(); ++i)
    for (std::uint32_t j = i + 1; j < a.size(); ++j)
      if (!in_one_layer(a, i, j) &&
          a.cell.nearest_image(a.position[i] - a.position[j]).norm() < a.radius[i] + a.radius[j])
        pairs.push_back({i, j});
  return pairs;
}

/// One of many small random clouds: 1 to 24 grains (or up to `most` in a cell as much larger), radii to 1:3, each axis
/// rigid or periodic or sheared, some grains glued.
inline Assembly fuzzed_cloud(std::uint64_t seed, std::size_t most = 24) {
  Dice dice(seed ^ 0x9e3779b97f4a7c15u);
  CloudShape shape;
  shape.grains = 1 + dice.below(most);
  shape.largest = 3e-3;
  shape.smallest = dice.between(1e-3, 3e-3);
  shape.overlap = dice.between(0.001, 0.02);
  const double scale = std::cbrt(static_cast<double>(most) / 24.0);
  Cell cell;
  cell.lower = dice.vector(0.02);
  for (int axis = 0; axis < 3; ++axis) {
    cell.periodic[axis] = dice.below(2) == 0;
    cell.upper[axis] = cell.lower[axis] + scale * dice.between(0.0135, 0.04);  // from two reaches of the largest on
  }
  if (cell.periodic[0] && cell.periodic[2] && dice.below(2) == 0)
    cell.shear_offset = dice.between(-0.5, 0.5) * cell.lengths().x();
  Assembly cloud = clustered_cloud(seed, cell, shape);
  if (dice.below(3) == 0)
    for (std::size_t i = 0; i < cloud.size(); ++i) cloud.role[i] = static_cast<Role>(dice.below(3));
  return cloud;
}

}  // namespace flowslide::native
