// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <cmath>

#include "dem/native/contact_pass.hpp"
#include "dem/native/isa/row.hpp"
#include "dem/native/isa/tile.hpp"

namespace flowslide::native {
inline namespace FLOWSLIDE_ISA {

/// Turns four rows of x, y, z, unused into the columns x, y, z of four lanes from `lane` on.
inline void put_columns(Row a, Row b, Row c, Row d, double (*columns)[tile_size], int lane) {
  const Row low_ab = __builtin_shufflevector(a, b, 0, 4, 2, 6), low_cd = __builtin_shufflevector(c, d, 0, 4, 2, 6);
  const Row high_ab = __builtin_shufflevector(a, b, 1, 5, 3, 7), high_cd = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  put_row(&columns[0][lane], __builtin_shufflevector(low_ab, low_cd, 0, 1, 4, 5));
  put_row(&columns[1][lane], __builtin_shufflevector(high_ab, high_cd, 0, 1, 4, 5));
  put_row(&columns[2][lane], __builtin_shufflevector(low_ab, low_cd, 2, 3, 6, 7));
}

/// The way back: four lanes of the columns x, y, z as rows x, y, z, 0.
inline void get_rows(const double (*columns)[tile_size], int lane, Row (&rows)[4]) {
  const Row x = row_at(&columns[0][lane]), y = row_at(&columns[1][lane]), z = row_at(&columns[2][lane]);
  const Row none{0.0, 0.0, 0.0, 0.0};
  const Row xy_even = __builtin_shufflevector(x, y, 0, 4, 2, 6), xy_odd = __builtin_shufflevector(x, y, 1, 5, 3, 7);
  const Row z_even = __builtin_shufflevector(z, none, 0, 4, 2, 6), z_odd = __builtin_shufflevector(z, none, 1, 5, 3, 7);
  rows[0] = __builtin_shufflevector(xy_even, z_even, 0, 1, 4, 5);
  rows[1] = __builtin_shufflevector(xy_odd, z_odd, 0, 1, 4, 5);
  rows[2] = __builtin_shufflevector(xy_even, z_even, 2, 3, 6, 7);
  rows[3] = __builtin_shufflevector(xy_odd, z_odd, 2, 3, 6, 7);
}

/// Fills a tile with the differences of position and velocity and the spins of the pairs from `start` on.
template <bool Spins>
inline void fetch(const PairView& pairs, std::size_t start, const Body* bodies, Tile& t) {
  for (int k = 0; k < Tile::size; k += 4) {
    Row separation[4], velocity[4], first_spin[4], second_spin[4];
    for (int m = 0; m < 4; ++m) {
      const Body& a = bodies[pairs.first[start + k + m]];
      const Body& b = bodies[pairs.second[start + k + m]];
      const Row image = row_at(b.position) + row_at(pairs.image_shift[pairs.image[start + k + m]]);
      separation[m] = row_at(a.position) - image;
      velocity[m] = row_at(a.velocity) - row_at(b.velocity);
      first_spin[m] = row_at(a.spin);
      second_spin[m] = row_at(b.spin);
    }
    put_columns(separation[0], separation[1], separation[2], separation[3], t.normal, k);
    put_columns(velocity[0], velocity[1], velocity[2], velocity[3], t.velocity, k);
    if constexpr (Spins) {
      put_columns(first_spin[0], first_spin[1], first_spin[2], first_spin[3], t.relative_spin, k);
      put_columns(second_spin[0], second_spin[1], second_spin[2], second_spin[3], t.surface_spin, k);
    }
  }
}

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
  fetch<Sliding || Rolling>(pairs, start, bodies, t);
  const double* __restrict first_radius = pairs.first_radius + start;
  const double* __restrict second_radius = pairs.second_radius + start;
#pragma omp simd
  for (int k = 0; k < Tile::size; ++k) {
    const double dx = t.normal[0][k], dy = t.normal[1][k], dz = t.normal[2][k];
    const double distance = std::sqrt(dx * dx + dy * dy + dz * dz);
    const double inverse = 1.0 / distance;
    const double gap = first_radius[k] + second_radius[k] - distance;
    const double overlap = gap > 0.0 ? gap : 0.0;
    const double first = first_radius[k] - 0.5 * overlap, second = second_radius[k] - 0.5 * overlap;
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
  for (int k = 0; k < Tile::size; k += 4) {
    Row force[4], first_torque[4], second_torque[4];
    get_rows(t.force, k, force);
    if constexpr (Sliding || Rolling) {
      get_rows(t.torque[0], k, first_torque);
      get_rows(t.torque[1], k, second_torque);
    }
    for (int m = 0; m < 4; ++m) {
      Load& a = loads[pairs.first[start + k + m]];
      Load& b = loads[pairs.second[start + k + m]];
      add_row(a.force, force[m]);
      add_row(b.force, -force[m]);
      if constexpr (Sliding || Rolling) {
        add_row(a.torque, first_torque[m]);
        add_row(b.torque, second_torque[m]);
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
