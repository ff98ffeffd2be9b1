// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

namespace flowslide::native {

/// One grain as the contact pass reads it: 96 bytes in double, 64 in float. `Real` is the precision of the law.
/// Positions are always double, because gaps are small differences of positions.
template <typename Real>
struct alignas(32) Body {
  double position[3];  ///< m, folded into the cell
  double radius;       ///< m
  Real velocity[3];    ///< m/s, at the half step during the evaluation of forces
  Real mass;           ///< kg
  Real spin[3];        ///< rad/s
  Real inertia;        ///< kg m^2
};

/// A grain in the precision `Real`.
template <typename Real>
Body<Real> in_precision(const Body<double>& body) {
  Body<Real> other;
  for (int axis = 0; axis < 3; ++axis) {
    other.position[axis] = body.position[axis];
    other.velocity[axis] = static_cast<Real>(body.velocity[axis]);
    other.spin[axis] = static_cast<Real>(body.spin[axis]);
  }
  other.radius = body.radius;
  other.mass = static_cast<Real>(body.mass);
  other.inertia = static_cast<Real>(body.inertia);
  return other;
}

/// Force and torque on a grain.
template <typename Real>
struct alignas(8 * sizeof(Real)) Load {
  Real force[3];  ///< N
  Real unused0;   ///< 0, so that a row of four numbers can be added to velocity and mass
  Real torque[3];  ///< N m
  Real unused1;
};

}  // namespace flowslide::native
