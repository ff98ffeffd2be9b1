// SPDX-License-Identifier: GPL-2.0-or-later
//
// The contact law of the native engine, over a tile of contacts: what a newcomer changes to try another law.
#pragma once
#include <cmath>

#include "dem/native/contact_pass.hpp"
#include "dem/native/isa/tile.hpp"

namespace flowslide::native {
inline namespace FLOWSLIDE_ISA {

/// Hertz normal force, tangential history with Coulomb cap, EPSD3 rolling (equations: grains/contact_law.hpp), for the
/// lanes of a tile. Reads geometry and motion, advances the histories, writes force and torques.
///
/// No branch: the overlap of an open pair is 0, which makes stiffness, forces and caps exactly 0, and scaling a history
/// by min(1, cap/size) then clears it. `Sliding` and `Rolling` say which parts the scene needs.
template <bool Sliding, bool Rolling>
inline void apply_law(const LawConstants& c, Tile& t) {
  constexpr double tiny = 1e-300;  // keeps 0/0 away and nothing else: 0/tiny = 0, x/tiny > 1
  const double* __restrict radii = t.effective_radius;
  const double* __restrict root_masses = t.root_effective_mass;
  const double* __restrict root_inertias = t.root_rolling_inertia;
  double* __restrict spring_x = t.spring[0];
  double* __restrict spring_y = t.spring[1];
  double* __restrict spring_z = t.spring[2];
  double* __restrict torque_x = t.rolling_torque[0];
  double* __restrict torque_y = t.rolling_torque[1];
  double* __restrict torque_z = t.rolling_torque[2];
#pragma omp simd
  for (int k = 0; k < Tile::size; ++k) {
    const double nx = t.normal[0][k], ny = t.normal[1][k], nz = t.normal[2][k];
    const double root = std::sqrt(radii[k] * t.overlap[k]);  // sqrt(R* delta)
    const double fourth_root = std::sqrt(root) * root_masses[k];
    const double kn = c.normal_stiffness * root;
    const double vn = t.velocity[0][k] * nx + t.velocity[1][k] * ny + t.velocity[2][k] * nz;
    const double normal = kn * t.overlap[k] - c.normal_damping * fourth_root * vn;
    const double bound = std::fabs(normal);

    double fx = 0.0, fy = 0.0, fz = 0.0;  // tangential
    if constexpr (Sliding) {
      // v_t = v - (v.n) n - W x n, W = c_1 w_1 + c_2 w_2
      const double wx = t.surface_spin[0][k], wy = t.surface_spin[1][k], wz = t.surface_spin[2][k];
      const double vx = t.velocity[0][k] - vn * nx - (nz * wy - ny * wz);
      const double vy = t.velocity[1][k] - vn * ny - (nx * wz - nz * wx);
      const double vz = t.velocity[2][k] - vn * nz - (ny * wx - nx * wy);
      double sx = spring_x[k] + vx * c.time_step;
      double sy = spring_y[k] + vy * c.time_step;
      double sz = spring_z[k] + vz * c.time_step;
      const double along = sx * nx + sy * ny + sz * nz;
      sx -= along * nx;
      sy -= along * ny;
      sz -= along * nz;
      const double kt = c.tangential_stiffness * root;
      const double elastic = kt * std::sqrt(sx * sx + sy * sy + sz * sz);
      const double cap = c.sliding_friction * bound;
      const bool sticks = elastic <= cap;
      const double ratio = cap / (elastic + tiny);
      const double scale = sticks ? (t.overlap[k] > 0.0 ? 1.0 : 0.0) : ratio;
      const double damping = sticks ? c.tangential_damping * fourth_root : 0.0;
      sx *= scale;
      sy *= scale;
      sz *= scale;
      fx = -kt * sx - damping * vx;
      fy = -kt * sy - damping * vy;
      fz = -kt * sz - damping * vz;
      spring_x[k] = sx;
      spring_y[k] = sy;
      spring_z[k] = sz;
    }

    double mx = 0.0, my = 0.0, mz = 0.0;  // rolling
    if constexpr (Rolling) {
      const double along = t.relative_spin[0][k] * nx + t.relative_spin[1][k] * ny + t.relative_spin[2][k] * nz;
      const double wx = t.relative_spin[0][k] - along * nx;
      const double wy = t.relative_spin[1][k] - along * ny;
      const double wz = t.relative_spin[2][k] - along * nz;
      const double radius = radii[k];
      const double kr = c.rolling_stiffness * kn * radius * radius;
      mx = torque_x[k] + wx * (c.time_step * kr);
      my = torque_y[k] + wy * (c.time_step * kr);
      mz = torque_z[k] + wz * (c.time_step * kr);
      const double size = std::sqrt(mx * mx + my * my + mz * mz);
      const double cap = c.rolling_friction * bound * radius;
      const bool holds = size <= cap;
      const double ratio = cap / (size + tiny);
      const double scale = holds ? 1.0 : ratio;
      const double damping = holds ? c.rolling_damping * root_inertias[k] * std::sqrt(kr) : 0.0;
      mx *= scale;
      my *= scale;
      mz *= scale;
      torque_x[k] = mx;
      torque_y[k] = my;
      torque_z[k] = mz;
      mx += damping * wx;
      my += damping * wy;
      mz += damping * wz;
    }

    t.force[0][k] = normal * nx + fx;
    t.force[1][k] = normal * ny + fy;
    t.force[2][k] = normal * nz + fz;
    // Torques: minus the lever arm times n x F_t on either, minus the rolling torque on the first, plus on the second.
    const double qx = ny * fz - nz * fy, qy = nz * fx - nx * fz, qz = nx * fy - ny * fx;
    const double first = t.arm[0][k], second = t.arm[1][k];
    t.torque[0][0][k] = -(first * qx) - mx;
    t.torque[0][1][k] = -(first * qy) - my;
    t.torque[0][2][k] = -(first * qz) - mz;
    t.torque[1][0][k] = -(second * qx) + mx;
    t.torque[1][1][k] = -(second * qy) + my;
    t.torque[1][2][k] = -(second * qz) + mz;
  }
}

}  // namespace FLOWSLIDE_ISA
}  // namespace flowslide::native
