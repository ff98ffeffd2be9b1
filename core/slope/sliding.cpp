// SPDX-License-Identifier: GPL-2.0-or-later
#include "slope/sliding.hpp"

#include <cmath>

#include "slope/require.hpp"

namespace flowslide {

Sliding::Sliding(const SlopeProperties& slope, double time_step) : mass_(mass_per_area(slope)), time_step_(time_step) {
  require_positive("time step dt_G", time_step, "s", "Give one such as 1e-4 s.");
}

SlidingState Sliding::start(double velocity, double driving, double resisting) const {
  return {0.0, velocity + 0.5 * time_step_ * (driving - resisting) / mass_};
}

double Sliding::move(SlidingState& state) const {
  const double increment = time_step_ * state.velocity;
  state.displacement += increment;
  return increment;
}

double Sliding::accelerate(SlidingState& state, double driving, double resisting) const {
  const double acceleration = (driving - resisting) / mass_;
  const double now = state.velocity + 0.5 * time_step_ * acceleration;
  state.velocity += time_step_ * acceleration;
  return now;
}

double sliding_time_step_limit(const SlopeProperties& slope, double shear_modulus) {
  require_positive("shear modulus of the sample", shear_modulus, "Pa", "Give an upper bound, such as 30 MPa.");
  return 2.0 / std::sqrt(shear_modulus / (slope.liquefiable_thickness * mass_per_area(slope)));
}

}  // namespace flowslide
