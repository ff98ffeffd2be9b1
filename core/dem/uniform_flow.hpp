// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "dem/engine.hpp"

namespace flowslide {

/// The affine field of velocities by which the whole cell follows its boundaries, in terms of the velocities that an
/// engine integrates:
///   u(x) = base + slope (z - origin) - rate (x - centre).
/// The compression of a periodic axis carries positions and enters no velocity: it is no part of the field.
struct UniformFlow {
  Vector3 base = Vector3::Zero();    ///< velocity at the height `origin`, m/s
  Vector3 slope = Vector3::Zero();   ///< du/dz, 1/s
  Vector3 rate = Vector3::Zero();    ///< rates of compression of the rigid lateral axes, 1/s; z is 0
  Vector3 centre = Vector3::Zero();  ///< of the cell, m
  double origin = 0.0;               ///< m

  /// u at a position (m), m/s.
  Vector3 at(const Vector3& position) const {
    return base + slope * (position.z() - origin) - rate.cwiseProduct(position - centre);
  }
};

/// The field of a cell whose boundaries move. The planes of a rigid axis and the glued layers have its velocity where
/// they are; nothing flows along a rigid lateral axis but by its compression. A cell that is periodic along z is
/// sheared about its middle, because its momentum is conserved.
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

/// The field that drag is relative to.
inline UniformFlow drag_flow(DragReference reference, const Cell& cell, const BoundaryMotion& motion) {
  return reference == DragReference::rest ? UniformFlow{} : uniform_flow(cell, motion);
}

}  // namespace flowslide
