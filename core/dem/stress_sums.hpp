// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "dem/engine.hpp"

namespace flowslide {

/// Sums from which an engine computes the stress of its cell without a loop over pairs, in N m and N. They belong to
/// the last evaluation of forces and exclude drag. Positions are measured from the lower planes.
struct StressSums {
  Vector3 mobile_height_times_force = Vector3::Zero();  ///< sum over mobile grains of z f
  Vector3 mobile_moment = Vector3::Zero();              ///< sums over mobile grains of x f_x, y f_y, z f_z
  Vector3 top_force = Vector3::Zero();                  ///< force of the top layer and its plane on the mobile grains
  Vector3 upper_plane = Vector3::Zero();                ///< forces of the upper planes on grains, each along its axis
  double pair_virial_x = 0.0, pair_virial_y = 0.0;      ///< sums over pairs of l_x f_x and l_y f_y
  Vector3 pair_virial_z = Vector3::Zero();              ///< sum over pairs of l_z f
};

/// Bagi's stress (eq. 12) on horizontal sections, in the form without pairs (see `bagi_stress`), and the lateral
/// stresses. For a rigid lateral axis the same form applies. Along a periodic axis the branch vectors of the pairs are
/// needed.
inline CellStress stress_of(const StressSums& sums, const Cell& cell) {
  // Compression positive: sum of z f - H F_top. The sign of shear changes, as in `slope_stress`.
  const Vector3 rigid = sums.mobile_height_times_force - cell.height() * sums.top_force;
  const Vector3 section = (cell.periodic[2] ? sums.pair_virial_z : rigid) / cell.volume();
  const auto lateral = [&](int axis, double pair_virial) {
    return (cell.periodic[axis] ? pair_virial
                                : sums.mobile_moment[axis] - cell.lengths()[axis] * sums.upper_plane[axis]) /
           cell.volume();
  };
  return {section.z(), -section.x(), -section.y(), lateral(0, sums.pair_virial_x), lateral(1, sums.pair_virial_y)};
}

}  // namespace flowslide
