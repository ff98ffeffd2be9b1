// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "dem/native/contact_pass.hpp"

namespace flowslide::native {
inline namespace FLOWSLIDE_ISA {

/// A group of contacts that are computed together, as arrays that fit in the first-level cache. `gather` fills it, the
/// law computes forces, and `scatter` adds them to the grains. The first of two indices is the component.
template <typename Real>
struct Tile {
  static constexpr int size = tile_size;
  template <typename T>
  using Lanes = T[size];

  alignas(64) Lanes<double> separation[3];  ///< x_1 - x_2, m
  // Geometry and motion, of the first grain relative to the second.
  alignas(64) Lanes<Real> normal[3];         ///< unit vector from the second to the first
  alignas(64) Lanes<Real> overlap;           ///< m; 0 for an open pair
  alignas(64) Lanes<Real> scale, root_scale; ///< s and sqrt(s) of the normal part (see grains/laws/lane.hpp)
  alignas(64) Lanes<Real> velocity[3];       ///< v_1 - v_2, m/s
  alignas(64) Lanes<Real> surface_spin[3];   ///< c_1 w_1 + c_2 w_2, m/s; after `fetch` w_1, rad/s
  alignas(64) Lanes<Real> relative_spin[3];  ///< w_1 - w_2, rad/s; after `fetch` w_2
  alignas(64) Lanes<Real> arm[2];            ///< c_1, c_2: lever arms R - overlap/2, m
  // Pointers into the pair list: constants of the pairs, and their histories, which the law advances.
  const Real* effective_radius;      ///< R*, m
  const Real* root_effective_mass;   ///< sqrt(m*)
  const Real* root_rolling_inertia;  ///< sqrt(I_r)
  Real* spring[3];                   ///< m
  Real* rolling_torque[3];           ///< N m
  // Results of the law.
  alignas(64) Lanes<Real> force[3];      ///< on the first, N
  alignas(64) Lanes<Real> torque[2][3];  ///< on the first and on the second, N m
};

}  // namespace FLOWSLIDE_ISA
}  // namespace flowslide::native
