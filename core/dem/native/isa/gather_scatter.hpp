// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <cmath>

#include "dem/native/contact_pass.hpp"
#include "dem/native/isa/tile.hpp"

namespace flowslide::native {
inline namespace FLOWSLIDE_ISA {

/// Fills a tile with geometry and motion of the pairs from `start` on.
template <bool Sliding, bool Rolling>
inline void gather(const PairView& pairs, std::size_t start, const Body* bodies, Tile& t) {
  t.effective_radius = pairs.effective_radius + start;
  t.root_effective_mass = pairs.root_effective_mass + start;
  t.root_rolling_inertia = pairs.root_rolling_inertia + start;
  for (int axis = 0; axis < 3; ++axis) {
    t.spring[axis] = pairs.spring[axis] + start;
    t.rolling_torque[axis] = pairs.rolling_torque[axis] + start;
  }
  for (int k = 0; k < Tile::size; ++k) {
    const Body& a = bodies[pairs.first[start + k]];
    const Body& b = bodies[pairs.second[start + k]];
    const double* shift = pairs.image_shift[pairs.image[start + k]];
    for (int axis = 0; axis < 3; ++axis) {
      t.normal[axis][k] = a.position[axis] - (b.position[axis] + shift[axis]);
      t.velocity[axis][k] = a.velocity[axis] - b.velocity[axis];
    }
    t.arm[0][k] = a.radius;
    t.arm[1][k] = b.radius;
    if constexpr (Sliding || Rolling)
      for (int axis = 0; axis < 3; ++axis) {
        t.relative_spin[axis][k] = a.spin[axis];
        t.surface_spin[axis][k] = b.spin[axis];
      }
  }
#pragma omp simd
  for (int k = 0; k < Tile::size; ++k) {
    const double dx = t.normal[0][k], dy = t.normal[1][k], dz = t.normal[2][k];
    const double distance = std::sqrt(dx * dx + dy * dy + dz * dz);
    const double inverse = 1.0 / distance;
    const double gap = t.arm[0][k] + t.arm[1][k] - distance;
    const double overlap = gap > 0.0 ? gap : 0.0;
    const double first = t.arm[0][k] - 0.5 * overlap, second = t.arm[1][k] - 0.5 * overlap;
    t.distance[k] = distance;
    t.normal[0][k] = dx * inverse;
    t.normal[1][k] = dy * inverse;
    t.normal[2][k] = dz * inverse;
    t.overlap[k] = overlap;
    t.arm[0][k] = first;
    t.arm[1][k] = second;
    if constexpr (Sliding || Rolling) {
      for (int axis = 0; axis < 3; ++axis) {
        const double spin_first = t.relative_spin[axis][k], spin_second = t.surface_spin[axis][k];
        t.surface_spin[axis][k] = first * spin_first + second * spin_second;
        t.relative_spin[axis][k] = spin_first - spin_second;
      }
    }
  }
}

/// Adds what the law has found to the grains, pair after pair in the order of the list.
template <bool Sliding, bool Rolling>
inline void scatter(const PairView& pairs, std::size_t start, const Tile& t, Load* loads) {
  for (int k = 0; k < Tile::size; ++k) {
    Load& a = loads[pairs.first[start + k]];
    Load& b = loads[pairs.second[start + k]];
    for (int axis = 0; axis < 3; ++axis) {
      a.force[axis] += t.force[axis][k];
      b.force[axis] -= t.force[axis][k];
      if constexpr (Sliding || Rolling) {
        a.torque[axis] += -(t.arm[0][k] * t.twist[axis][k]) - t.rolling[axis][k];
        b.torque[axis] += -(t.arm[1][k] * t.twist[axis][k]) + t.rolling[axis][k];
      }
    }
  }
}

inline void add_virial(const Tile& t, double* virial) {
  for (int k = 0; k < Tile::size; ++k) {
    virial[0] += t.distance[k] * t.normal[0][k] * t.force[0][k];
    virial[1] += t.distance[k] * t.normal[1][k] * t.force[1][k];
  }
}

}  // namespace FLOWSLIDE_ISA
}  // namespace flowslide::native
