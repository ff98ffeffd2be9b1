// SPDX-License-Identifier: GPL-2.0-or-later
#include "coupling/stop.hpp"

#include <cmath>

#include "grains/require.hpp"

namespace flowslide {

void validate(const StopConditions& conditions) {
  require(std::isfinite(conditions.end_time) && conditions.end_time > 0.0, "end time", conditions.end_time,
          "finite and > 0 s", "Give one such as 10 s.");
  require(conditions.end_shear_strain > 0.0, "shear strain at the end", conditions.end_shear_strain, "> 0",
          "Leave it out to go on to the end time.");
  require(conditions.sliding_velocity > 0.0, "velocity of a slide", conditions.sliding_velocity, "> 0 m/s",
          "Leave it out to go on to the end time.");
  require(conditions.end_velocity > 0.0, "velocity at the end", conditions.end_velocity, "> 0 m/s",
          "Leave it out to go on to the end time.");
}

Stop stop_of(const SlideState& state, const StopConditions& conditions, double time_step) {
  // The tolerance of half a step absorbs the rounding of the time, which is a number of steps times dt_G.
  if (state.time > conditions.end_time - 0.5 * time_step) return Stop::end_time;
  if (state.strain.shear >= conditions.end_shear_strain) return Stop::end_shear_strain;
  if (state.largest_velocity > conditions.sliding_velocity && state.velocity <= 0.0) return Stop::sliding_stopped;
  if (state.velocity >= conditions.end_velocity) return Stop::end_velocity;
  return Stop::not_yet;
}

}  // namespace flowslide
