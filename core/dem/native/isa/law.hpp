// SPDX-License-Identifier: GPL-2.0-or-later
//
// The contact law of the native engine for a tile of contacts: composed of the parts in grains/laws.
#pragma once
#include <cmath>

#include "dem/native/isa/tile.hpp"

namespace flowslide::native {
inline namespace FLOWSLIDE_ISA {

template <typename Real>
FLOWSLIDE_LANE laws::Components<Real> components_at(const Real (&columns)[3][tile_size], int k) {
  return {columns[0][k], columns[1][k], columns[2][k]};
}
template <typename Real>
FLOWSLIDE_LANE laws::Components<Real> components_at(Real* const (&columns)[3], int k) {
  return {columns[0][k], columns[1][k], columns[2][k]};
}
template <typename Columns, typename Real>
FLOWSLIDE_LANE void put(const laws::Components<Real>& value, Columns& columns, int k) {
  columns[0][k] = value.x;
  columns[1][k] = value.y;
  columns[2][k] = value.z;
}

/// Force and torques of contact `k` of a tile by the parts of `Law`. Reads geometry and motion, advances the histories,
/// and writes forces and torques. There is no branch. `Sliding` and `Rolling` select the parts; rolling requires
/// sliding.
template <typename Real, typename Law, bool Sliding, bool Rolling>
FLOWSLIDE_LANE void apply_to_contact(const LawConstants<Real>& constants, Tile<Real>& t, int k) {
  using laws::Components;
  const auto& normal_part = constants.template of<typename Law::Normal>();
  laws::Lane<Real> contact;
  contact.normal = components_at(t.normal, k);
  contact.overlap = t.overlap[k];
  contact.scale = t.scale[k];
  contact.root_scale = t.root_scale[k];
  contact.root_effective_mass = t.root_effective_mass[k];
  contact.velocity = components_at(t.velocity, k);
  contact.separation_velocity = dot(contact.velocity, contact.normal);
  contact.time_step = constants.time_step;
  const Real normal = Law::Normal::force(normal_part, contact);
  const Real bound = std::fabs(normal);

  Components<Real> tangential;
  if constexpr (Sliding) {
    contact.surface_spin = components_at(t.surface_spin, k);
    Components<Real> spring = components_at(t.spring, k);
    tangential = Law::Tangential::force(constants.template of<typename Law::Tangential>(), normal_part, contact, bound,
                                        spring);
    put(spring, t.spring, k);
  }
  Components<Real> rolling;
  if constexpr (Rolling) {
    contact.effective_radius = t.effective_radius[k];
    contact.root_rolling_inertia = t.root_rolling_inertia[k];
    contact.relative_spin = components_at(t.relative_spin, k);
    Components<Real> torque;  // of a part without history: 0, also after a change of the law
    if constexpr (Law::Rolling::has_history) torque = components_at(t.rolling_torque, k);
    rolling = Law::Rolling::torque(constants.template of<typename Law::Rolling>(), normal_part, contact, bound, torque);
    put(torque, t.rolling_torque, k);
  }

  put(add_scaled(tangential, normal, contact.normal), t.force, k);
  // Torques: lever arm times F_t x n on both grains; minus the rolling torque on the first, plus on the second.
  const Components<Real> moment = cross(tangential, contact.normal);
  put(add_scaled(Components<Real>{-rolling.x, -rolling.y, -rolling.z}, t.arm[0][k], moment), t.torque[0], k);
  put(add_scaled(rolling, t.arm[1][k], moment), t.torque[1], k);
}

/// Forces and torques of all contacts of a tile. The loop calls one function that is inlined whole: its variables then
/// are numbers in registers. Variables of the loop itself that are passed by reference would become arrays over the
/// lanes, and variables of functions that these call would not (g++ 12 then gives wrong numbers).
template <typename Real, typename Law, bool Sliding, bool Rolling>
inline void apply_law(const LawConstants<Real>& constants, Tile<Real>& t) {
#pragma omp simd
  for (int k = 0; k < Tile<Real>::size; ++k) apply_to_contact<Real, Law, Sliding, Rolling>(constants, t, k);
}

}  // namespace FLOWSLIDE_ISA
}  // namespace flowslide::native
