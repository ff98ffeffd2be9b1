// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "dem/engine.hpp"

namespace flowslide {

/// The affine velocity field with which the whole cell follows its boundaries:
///   u(x) = base + slope (z - origin) - rate (x - centre).
/// It is expressed in the velocities that an engine integrates. It excludes the compression of a periodic axis, which
/// moves the grains without changing their velocities.
struct UniformFlow {
  Vector3 base = Vector3::Zero();    ///< velocity at the height `origin`, m/s
  Vector3 slope = Vector3::Zero();   ///< du/dz, 1/s
  Vector3 rate = Vector3::Zero();    ///< compression rates of the rigid lateral axes, 1/s; the z component is 0
  Vector3 centre = Vector3::Zero();  ///< centre of the cell, m
  double origin = 0.0;               ///< height of `base`, m

  /// u at a position (m), m/s.
  Vector3 at(const Vector3& position) const {
    return base + slope * (position.z() - origin) - rate.cwiseProduct(position - centre);
  }
};

/// The field of a cell with moving boundaries. At the planes of a rigid axis and at the glued layers it equals their
/// velocity. Along a rigid lateral axis it contains only the compression. A cell that is periodic along z is sheared
/// about its middle, because its momentum is conserved.
inline UniformFlow uniform_flow(const Cell& cell, const BoundaryMotion& motion) {
  UniformFlow flow;
  flow.centre = 0.5 * (cell.lower + cell.upper);
  if (!cell.periodic[0]) flow.rate.x() = motion.compression_rate_x;
  if (!cell.periodic[1]) flow.rate.y() = motion.compression_rate_y;
  if (cell.periodic[2]) {
    flow.slope[0] = cell.shear_velocity / cell.height();
    flow.origin = flow.centre.z();
    return flow;
  }
  for (int axis = 0; axis < 3; ++axis) {
    if (axis < 2 && !cell.periodic[axis]) continue;
    flow.base[axis] = motion.bottom_velocity[axis];
    flow.slope[axis] = (motion.top_velocity[axis] - motion.bottom_velocity[axis]) / cell.height();
  }
  flow.origin = cell.lower.z();
  return flow;
}

/// The velocity field u of the drag force -c (v - u).
inline UniformFlow drag_flow(DragReference reference, const Cell& cell, const BoundaryMotion& motion) {
  return reference == DragReference::rest ? UniformFlow{} : uniform_flow(cell, motion);
}

}  // namespace flowslide
