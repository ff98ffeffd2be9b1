// SPDX-License-Identifier: GPL-2.0-or-later
//
// The contact law of the native engine for a tile of contacts. Change this file to try another law.
#pragma once
#include <cmath>

#include "dem/native/isa/fused.hpp"
#include "dem/native/isa/roots.hpp"
#include "dem/native/isa/tile.hpp"

namespace flowslide::native {
inline namespace FLOWSLIDE_ISA {

/// Hertz normal force, tangential history with Coulomb cap, and EPSD3 rolling (equations: grains/contact_law.hpp) for
/// all contacts of a tile. Reads geometry and motion, advances the histories, and writes forces and torques.
///
/// There is no branch. The overlap of an open pair is 0, which makes stiffness, forces and caps exactly 0. The scaling
/// of a history by min(1, cap/size) then clears it. `Sliding` and `Rolling` select the parts of the law; rolling
/// requires sliding.
template <typename Real, bool Sliding, bool Rolling>
inline void apply_law(const LawConstants<Real>& c, Tile<Real>& t) {
  using std::fma;
  constexpr Real tiny = smallest_argument<Real>;  // only avoids 0/0
  const Real* __restrict radii = t.effective_radius;
  const Real* __restrict root_masses = t.root_effective_mass;
  const Real* __restrict root_inertias = t.root_rolling_inertia;
  Real* __restrict spring_x = t.spring[0];
  Real* __restrict spring_y = t.spring[1];
  Real* __restrict spring_z = t.spring[2];
  Real* __restrict torque_x = t.rolling_torque[0];
  Real* __restrict torque_y = t.rolling_torque[1];
  Real* __restrict torque_z = t.rolling_torque[2];
#pragma omp simd
  for (int k = 0; k < Tile<Real>::size; ++k) {
    const Real nx = t.normal[0][k], ny = t.normal[1][k], nz = t.normal[2][k];
    const Real kn = c.normal_stiffness * t.root[k];
    const Real dashpot = t.fourth_root[k] * root_masses[k];
    const Real ux = t.velocity[0][k], uy = t.velocity[1][k], uz = t.velocity[2][k];
    const Real vn = dot(ux, uy, uz, nx, ny, nz);
    const Real normal = difference_of_products(kn, t.overlap[k], c.normal_damping * dashpot, vn);
    const Real bound = std::fabs(normal);

    Real fx = 0, fy = 0, fz = 0;  // tangential force
    if constexpr (Sliding) {
      // v_t = v - (v.n) n - W x n, W = c_1 w_1 + c_2 w_2; the spring advances and is projected on the contact plane.
      const Real wx = t.surface_spin[0][k], wy = t.surface_spin[1][k], wz = t.surface_spin[2][k];
      const Real vx = fma(-vn, nx, ux) - difference_of_products(nz, wy, ny, wz);
      const Real vy = fma(-vn, ny, uy) - difference_of_products(nx, wz, nz, wx);
      const Real vz = fma(-vn, nz, uz) - difference_of_products(ny, wx, nx, wy);
      Real sx = fma(vx, c.time_step, spring_x[k]);
      Real sy = fma(vy, c.time_step, spring_y[k]);
      Real sz = fma(vz, c.time_step, spring_z[k]);
      const Real along = dot(sx, sy, sz, nx, ny, nz);
      sx = fma(-along, nx, sx);
      sy = fma(-along, ny, sy);
      sz = fma(-along, nz, sz);
      const Real kt = c.tangential_stiffness * t.root[k];
      const Real elastic = fma(kt, std::sqrt(dot(sx, sy, sz, sx, sy, sz)), tiny);
      const Real cap = c.sliding_friction * bound;
      const bool sticks = elastic <= cap;
      const Real ratio = cap / elastic;
      const Real scale = sticks ? Real(1) : ratio;
      const Real damping = sticks ? c.tangential_damping * dashpot : Real(0);
      sx *= scale;
      sy *= scale;
      sz *= scale;
      fx = difference_of_products(-kt, sx, damping, vx);
      fy = difference_of_products(-kt, sy, damping, vy);
      fz = difference_of_products(-kt, sz, damping, vz);
      spring_x[k] = sx;
      spring_y[k] = sy;
      spring_z[k] = sz;
    }

    Real mx = 0, my = 0, mz = 0;  // rolling torque
    if constexpr (Rolling) {
      const Real rx = t.relative_spin[0][k], ry = t.relative_spin[1][k], rz = t.relative_spin[2][k];
      const Real along = dot(rx, ry, rz, nx, ny, nz);
      const Real wx = fma(-along, nx, rx);
      const Real wy = fma(-along, ny, ry);
      const Real wz = fma(-along, nz, rz);
      const Real radius = radii[k];
      const Real turn = c.time_step * (c.rolling_stiffness * kn * (radius * radius));
      mx = fma(wx, turn, torque_x[k]);
      my = fma(wy, turn, torque_y[k]);
      mz = fma(wz, turn, torque_z[k]);
      const Real squared = dot(mx, my, mz, mx, my, mz);
      const Real cap = c.rolling_friction * bound * radius;
      const bool holds = squared <= cap * cap;
      const Real ratio = cap * inverse_root(squared > tiny ? squared : tiny);
      const Real scale = holds ? Real(1) : ratio;
      const Real damping = holds ? c.rolling_damping * root_inertias[k] * (radius * t.fourth_root[k]) : Real(0);
      mx *= scale;
      my *= scale;
      mz *= scale;
      torque_x[k] = mx;
      torque_y[k] = my;
      torque_z[k] = mz;
      mx = fma(damping, wx, mx);
      my = fma(damping, wy, my);
      mz = fma(damping, wz, mz);
    }

    t.force[0][k] = fma(normal, nx, fx);
    t.force[1][k] = fma(normal, ny, fy);
    t.force[2][k] = fma(normal, nz, fz);
    // Torques: lever arm times F_t x n on both grains; minus the rolling torque on the first, plus on the second.
    const Real qx = difference_of_products(nz, fy, ny, fz);
    const Real qy = difference_of_products(nx, fz, nz, fx);
    const Real qz = difference_of_products(ny, fx, nx, fy);
    const Real first = t.arm[0][k], second = t.arm[1][k];
    t.torque[0][0][k] = fma(first, qx, -mx);
    t.torque[0][1][k] = fma(first, qy, -my);
    t.torque[0][2][k] = fma(first, qz, -mz);
    t.torque[1][0][k] = fma(second, qx, mx);
    t.torque[1][1][k] = fma(second, qy, my);
    t.torque[1][2][k] = fma(second, qz, mz);
  }
}

}  // namespace FLOWSLIDE_ISA
}  // namespace flowslide::native
