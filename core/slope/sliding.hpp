// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "slope/statics.hpp"

namespace flowslide {

/// State of the central differences: the velocity is half a step ahead of the displacement.
struct SlidingState {
  double displacement = 0.0;  ///< x at t, m, positive downslope
  double velocity = 0.0;      ///< v at t + dt_G/2, m/s
};

/// Balance of momentum m a = tau_d - tau (eq. 1), integrated by central differences (steps 2, 4, 9 and 10 of
/// Algorithm 1). It is of second order in dt_G if tau depends on the displacement alone. A tau that depends on the
/// velocity is known half a step late, which reduces the order to one. Stable up to `sliding_time_step_limit`.
class Sliding {
 public:
  /// `time_step` is dt_G (s, > 0). Throws std::invalid_argument if it or the slope is invalid.
  Sliding(const SlopeProperties& slope, double time_step);

  /// Step 2: v(dt/2) = v0 + a0 dt/2. `velocity` is v0 (m/s); `driving` and `resisting` are tau_d and tau at t = 0 (Pa).
  SlidingState start(double velocity, double driving, double resisting) const;
  /// Step 4: x += dt v. Returns the displacement of the step, m.
  double move(SlidingState& state) const;
  /// Steps 9 and 10: v += dt a. Returns v at the time of the stresses, half a step before the new v, m/s.
  double accelerate(SlidingState& state, double driving, double resisting) const;

 private:
  double mass_, time_step_;
};

/// Largest stable time step: dt_G = 2/omega, s. omega = sqrt(G/(h_s m)) is the angular frequency at which the slide
/// oscillates on a sample of shear modulus G (`shear_modulus`, Pa, > 0). The limit assumes that the stress is measured
/// at every step. Throws std::invalid_argument.
double sliding_time_step_limit(const SlopeProperties& slope, double shear_modulus);

}  // namespace flowslide
