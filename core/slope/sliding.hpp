// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "slope/statics.hpp"

namespace flowslide {

/// The slide on the staggered grid of central differences.
struct SlidingState {
  double displacement = 0.0;  ///< x at t, m, positive downslope
  double velocity = 0.0;      ///< v at t + dt_G/2, m/s
};

/// Balance of momentum m a = tau_d - tau (eq. 1) by central differences, steps 2, 4, 9 and 10 of Algorithm 1. Of second
/// order in dt_G as long as tau depends on the displacement alone; a tau that depends on the velocity is known half a
/// step late, which leaves the first order. Stable up to `sliding_time_step_limit`.
class Sliding {
 public:
  /// `time_step` is dt_G, s, > 0. The slope is validated; throws std::invalid_argument.
  Sliding(const SlopeProperties& slope, double time_step);

  /// Step 2: v(dt/2) = v0 + dt/2 a0 from the initial velocity (m/s) and stresses (Pa).
  SlidingState start(double velocity, double driving, double resisting) const;
  /// Step 4: x += dt v. Returns the displacement of the step, m.
  double move(SlidingState& state) const;
  /// Steps 9 and 10: v += dt a. Returns the velocity half a step earlier, at the time of the stresses, m/s.
  double accelerate(SlidingState& state, double driving, double resisting) const;

 private:
  double mass_, time_step_;
};

/// dt_G = 2/omega, s: the longest step at which the slide swings on a sample without growing, omega = sqrt(G/(h_s m)),
/// G its `shear_modulus` (Pa, > 0). It holds for a stress that is told at every step.
double sliding_time_step_limit(const SlopeProperties& slope, double shear_modulus);

}  // namespace flowslide
