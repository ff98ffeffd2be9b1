// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <optional>
#include <string>

#include "dem/engine.hpp"

namespace flowslide {

/// Target stresses of a servo, Pa, compression positive.
struct ServoTarget {
  double normal = 0.0;           ///< target of all three normal stresses
  std::optional<double> shear;   ///< target of tau, reached by the glued top layer; empty: no motion along x
  double rate_limit = 0.05;      ///< largest strain rate of any boundary, 1/s
};

/// Boundary motion of a proportional servo. Each axis has the strain rate r clamp((s_t - s)/s_t, -1, 1), with the
/// normal stress s, its target s_t and r = `rate_limit`. For the shear stress the argument is 5 (tau_t - tau)/s_t,
/// because shear is softer and tau_t is much smaller than s_t. With a shear target the bottom stands still; otherwise
/// both z planes move. The gain must stay low: a dense sample has a modulus M of up to 100 MPa, and the servo
/// oscillates forever if r M/s_t times the control interval exceeds about 0.2.
BoundaryMotion servo_motion(const ServoTarget& target, const Cell& cell, const CellStress& stress);

/// Largest deviation of a stress from its target, as a fraction of the normal target.
double servo_deviation(const ServoTarget& target, const CellStress& stress);

}  // namespace flowslide
