// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <cmath>

#include "dem/native/isa/roots.hpp"
#include "dem/native/isa/tile.hpp"
#include "dem/native/isa/transpose.hpp"

namespace flowslide::native {
inline namespace FLOWSLIDE_ISA {

/// Fills a tile with separations, relative velocities and spins of the pairs from `start` on.
template <typename Real, bool Spins>
inline void fetch(const PairView<Real>& pairs, std::size_t start, const Body<Real>* bodies, Tile<Real>& t) {
  const std::uint32_t *first = pairs.first + start, *second = pairs.second + start;
  const std::uint8_t* image = pairs.image + start;
  for (int k = 0; k < Tile<Real>::size; k += lanes_of_bands<double>) {
    Band<double> separation[4];
    for (int m = 0; m < 4; ++m) {
      const auto a = band_of<double>(m, [&](int l) { return row_at(bodies[first[k + l]].position); });
      const auto b = band_of<double>(m, [&](int l) { return row_at(bodies[second[k + l]].position); });
      const auto shift = band_of<double>(m, [&](int l) { return row_at(pairs.image_shift[image[k + l]]); });
      separation[m] = a - (b + shift);
    }
    put_columns(separation, &t.separation[0][k], &t.separation[1][k], &t.separation[2][k]);
  }
  for (int k = 0; k < Tile<Real>::size; k += lanes_of_bands<Real>) {
    Band<Real> velocity[4], first_spin[4], second_spin[4];
    for (int m = 0; m < 4; ++m) {
      const auto a = band_of<Real>(m, [&](int l) { return row_at(bodies[first[k + l]].velocity); });
      const auto b = band_of<Real>(m, [&](int l) { return row_at(bodies[second[k + l]].velocity); });
      velocity[m] = a - b;
      if constexpr (Spins) {
        first_spin[m] = band_of<Real>(m, [&](int l) { return row_at(bodies[first[k + l]].spin); });
        second_spin[m] = band_of<Real>(m, [&](int l) { return row_at(bodies[second[k + l]].spin); });
      }
    }
    put_columns(velocity, &t.velocity[0][k], &t.velocity[1][k], &t.velocity[2][k]);
    if constexpr (Spins) {
      put_columns(first_spin, &t.surface_spin[0][k], &t.surface_spin[1][k], &t.surface_spin[2][k]);
      put_columns(second_spin, &t.relative_spin[0][k], &t.relative_spin[1][k], &t.relative_spin[2][k]);
    }
  }
}

/// Distance of two centres and gap between two spheres, from the square of the distance. In float, the gap is taken
/// from the difference of the squares, in double: a difference of two lengths in float would be all rounding.
template <typename Real>
inline void measure(double squared, double touching, Real& inverse_distance, Real& overlap) {
  if constexpr (std::is_same_v<Real, double>) {
    inverse_distance = inverse_root(squared);
    const double depth = touching - std::sqrt(squared);  // rounded once: a gap is all that is left of it
    overlap = depth > 0.0 ? depth : 0.0;
  } else {
    const float difference = static_cast<float>(touching * touching - squared);
    const float distance = std::sqrt(static_cast<float>(squared)), sum = static_cast<float>(touching) + distance;
    const float inverse = 1.0F / (distance * sum);
    inverse_distance = sum * inverse;
    const float depth = difference * (distance * inverse);
    overlap = depth > 0.0F ? depth : 0.0F;
  }
}

/// Fills a tile with geometry and motion of the pairs from `start` on.
template <typename Real, bool Spins>
inline void gather(const PairView<Real>& pairs, std::size_t start, const Body<Real>* bodies, Tile<Real>& t) {
  t.effective_radius = pairs.effective_radius + start;
  t.root_effective_mass = pairs.root_effective_mass + start;
  t.root_rolling_inertia = pairs.root_rolling_inertia + start;
  for (int axis = 0; axis < 3; ++axis) {
    t.spring[axis] = pairs.spring[axis] + start;
    t.rolling_torque[axis] = pairs.rolling_torque[axis] + start;
  }
  fetch<Real, Spins>(pairs, start, bodies, t);
  const double* __restrict first_radius = pairs.first_radius + start;
  const double* __restrict second_radius = pairs.second_radius + start;
  const Real* __restrict radii = t.effective_radius;
#pragma omp simd
  for (int k = 0; k < Tile<Real>::size; ++k) {
    const double dx = t.separation[0][k], dy = t.separation[1][k], dz = t.separation[2][k];
    Real inverse, overlap;
    measure(dx * dx + dy * dy + dz * dz, first_radius[k] + second_radius[k], inverse, overlap);
    const Real half = Real(0.5) * overlap;
    const Real first = static_cast<Real>(first_radius[k]) - half, second = static_cast<Real>(second_radius[k]) - half;
    t.normal[0][k] = static_cast<Real>(dx) * inverse;
    t.normal[1][k] = static_cast<Real>(dy) * inverse;
    t.normal[2][k] = static_cast<Real>(dz) * inverse;
    t.overlap[k] = overlap;
    two_roots(radii[k] * overlap, t.root[k], t.fourth_root[k]);
    t.arm[0][k] = first;
    t.arm[1][k] = second;
    if constexpr (Spins) {
      for (int axis = 0; axis < 3; ++axis) {
        const Real spin_first = t.surface_spin[axis][k], spin_second = t.relative_spin[axis][k];
        t.surface_spin[axis][k] = first * spin_first + second * spin_second;
        t.relative_spin[axis][k] = spin_first - spin_second;
      }
    }
  }
}

}  // namespace FLOWSLIDE_ISA
}  // namespace flowslide::native
