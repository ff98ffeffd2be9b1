// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <cmath>

#include "dem/native/isa/tile.hpp"
#include "dem/native/isa/transpose.hpp"
#include "grains/laws/fused.hpp"

namespace flowslide::native {
inline namespace FLOWSLIDE_ISA {

/// Fills a tile with separations, relative velocities and spins of the pairs from index `start`.
template <typename Real, bool Spins>
inline void fetch(const PairView<Real>& pairs, std::size_t start, const Body<Real>* bodies, Tile<Real>& t) {
  // Computes each address once for all reads.
  const Body<Real>*first[tile_size], *second[tile_size];
  const double* shift_of[tile_size];
  for (int k = 0; k < tile_size; ++k) {
    first[k] = bodies + pairs.first[start + k];
    second[k] = bodies + pairs.second[start + k];
    shift_of[k] = pairs.image_shift[pairs.image[start + k]];
  }
  for (int k = 0; k < Tile<Real>::size; k += lanes_of_bands<double>) {
    Band<double> separation[4];
    for (int m = 0; m < 4; ++m) {
      const int lane = k + m;
      const auto a = band_of<double>([&](int r) { return first[lane + 4 * r]->position; });
      const auto b = band_of<double>([&](int r) { return second[lane + 4 * r]->position; });
      const auto shift = band_of<double>([&](int r) { return shift_of[lane + 4 * r]; });
      separation[m] = a - (b + shift);
    }
    put_columns(separation, &t.separation[0][k], &t.separation[1][k], &t.separation[2][k]);
  }
  for (int k = 0; k < Tile<Real>::size; k += lanes_of_bands<Real>) {
    Band<Real> velocity[4], first_spin[4], second_spin[4];
    for (int m = 0; m < 4; ++m) {
      const int lane = k + m;
      const auto a = [&](int r) -> const Body<Real>& { return *first[lane + 4 * r]; };
      const auto b = [&](int r) -> const Body<Real>& { return *second[lane + 4 * r]; };
      velocity[m] = band_of<Real>([&](int r) { return a(r).velocity; }) -
                    band_of<Real>([&](int r) { return b(r).velocity; });
      if constexpr (Spins) {
        first_spin[m] = band_of<Real>([&](int r) { return a(r).spin; });
        second_spin[m] = band_of<Real>([&](int r) { return b(r).spin; });
      }
    }
    put_columns(velocity, &t.velocity[0][k], &t.velocity[1][k], &t.velocity[2][k]);
    if constexpr (Spins) {
      put_columns(first_spin, &t.surface_spin[0][k], &t.surface_spin[1][k], &t.surface_spin[2][k]);
      put_columns(second_spin, &t.relative_spin[0][k], &t.relative_spin[1][k], &t.relative_spin[2][k]);
    }
  }
}

/// Makes the velocities of a tile relative to the moving images of a sheared cell.
template <typename Real>
inline void follow_images(const PairView<Real>& pairs, std::size_t start, Tile<Real>& t) {
  for (int k = 0; k < Tile<Real>::size; ++k)
    t.velocity[0][k] -= static_cast<Real>(layer_of(pairs.image[start + k])) * pairs.image_velocity;
}

/// Inverse distance of two centres and overlap of two spheres, from the square of the distance (m^2) and the sum of the
/// radii `touching` (m). With float, the overlap comes from the difference of the squares in double, because the
/// rounding of two lengths in float would exceed their difference.
template <typename Real>
inline void measure(double squared, double touching, Real& inverse_distance, Real& overlap) {
  if constexpr (std::is_same_v<Real, double>) {
    const double distance = std::sqrt(squared);
    inverse_distance = 1.0 / distance;
    const double depth = touching - distance;
    overlap = depth > 0.0 ? depth : 0.0;
  } else {
    const float difference = static_cast<float>(std::fma(touching, touching, -squared));
    const float distance = std::sqrt(static_cast<float>(squared)), sum = static_cast<float>(touching) + distance;
    const float inverse = 1.0F / (distance * sum);
    inverse_distance = sum * inverse;
    const float depth = difference * (distance * inverse);
    overlap = depth > 0.0F ? depth : 0.0F;
  }
}

/// Fills a tile with geometry and motion of the pairs from index `start`. `Normal` is the normal part of the law. It
/// stays a function of its own: within the loop over tiles, g++ keeps more of its numbers on the stack.
template <typename Real, typename Normal, bool Spins>
[[gnu::noinline]] void gather(const PairView<Real>& pairs, std::size_t start, const Body<Real>* bodies, Tile<Real>& t) {
  t.effective_radius = pairs.effective_radius + start;
  t.root_effective_mass = pairs.root_effective_mass + start;
  t.root_rolling_inertia = pairs.root_rolling_inertia + start;
  for (int axis = 0; axis < 3; ++axis) {
    t.spring[axis] = pairs.spring[axis] + start;
    t.rolling_torque[axis] = pairs.rolling_torque[axis] + start;
  }
  fetch<Real, Spins>(pairs, start, bodies, t);
  if (pairs.image_velocity != Real(0)) follow_images(pairs, start, t);
  const double* __restrict first_radius = pairs.first_radius + start;
  const double* __restrict second_radius = pairs.second_radius + start;
  const Real* __restrict radii = t.effective_radius;
  [[maybe_unused]] const Real* __restrict root_scales = Normal::scale_is_constant ? pairs.root_scale + start : nullptr;
#pragma omp simd
  for (int k = 0; k < Tile<Real>::size; ++k) {
    const laws::Components<double> apart{t.separation[0][k], t.separation[1][k], t.separation[2][k]};
    Real inverse, overlap;
    measure(laws::dot(apart, apart), first_radius[k] + second_radius[k], inverse, overlap);
    const Real half = Real(0.5) * overlap;
    const Real first = static_cast<Real>(first_radius[k]) - half, second = static_cast<Real>(second_radius[k]) - half;
    t.normal[0][k] = static_cast<Real>(apart.x) * inverse;
    t.normal[1][k] = static_cast<Real>(apart.y) * inverse;
    t.normal[2][k] = static_cast<Real>(apart.z) * inverse;
    t.overlap[k] = overlap;
    if constexpr (Normal::scale_is_constant) {
      const Real root_scale = overlap > Real(0) ? root_scales[k] : Real(0);
      t.scale[k] = root_scale * root_scale;
      t.root_scale[k] = root_scale;
    } else {
      Normal::scales(radii[k], overlap, t.scale[k], t.root_scale[k]);
    }
    t.arm[0][k] = first;
    t.arm[1][k] = second;
    if constexpr (Spins) {
      for (int axis = 0; axis < 3; ++axis) {
        const Real spin_first = t.surface_spin[axis][k], spin_second = t.relative_spin[axis][k];
        t.surface_spin[axis][k] = first * spin_first + second * spin_second;  // unfused: symmetric in both grains
        t.relative_spin[axis][k] = spin_first - spin_second;
      }
    }
  }
}

}  // namespace FLOWSLIDE_ISA
}  // namespace flowslide::native
