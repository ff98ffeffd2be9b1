// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <optional>
#include <string>

#include "dem/engine.hpp"

namespace flowslide {

/// Stresses that a servo drives the boundaries to, Pa.
struct ServoTarget {
  double normal = 0.0;           ///< of all three axes
  std::optional<double> shear;   ///< sigma_zx through the glued top layer; without it the top does not move sideways
  double rate_limit = 0.05;      ///< largest strain rate of any boundary, 1/s
};

/// Strain rates proportional to what is missing, r clamp((s_t - s)/s_t, -1, 1), as motion of the boundaries; shear is
/// softer and much smaller than the normal stress, so it counts what is missing five times.
/// With a shear target the bottom stands still, else both z planes move. The gain must stay low: a dense sample
/// answers with a modulus M of up to 100 MPa, and r M/s_t times the control interval above some 0.2 cycles for ever.
BoundaryMotion servo_motion(const ServoTarget& target, const Cell& cell, const CellStress& stress);

/// Largest deviation of a stress from its target, as a share of the normal target.
double servo_deviation(const ServoTarget& target, const CellStress& stress);

}  // namespace flowslide
