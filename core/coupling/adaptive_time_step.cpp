// SPDX-License-Identifier: GPL-2.0-or-later
#include "coupling/adaptive_time_step.hpp"

#include <algorithm>
#include <cmath>

#include "grains/require.hpp"

namespace flowslide {

void validate(const AdaptiveTimeStep& adaptive) {
  require(adaptive.smallest > 0.0, "time step dt_L", adaptive.smallest, "> 0 s", "Give one such as 1e-5 s.");
  require(std::isfinite(adaptive.largest) && adaptive.largest >= adaptive.smallest, "largest local time step",
          adaptive.largest, "dt_L or more, s", "Leave it out for a constant dt_L.");
  require(adaptive.interval >= 1, "local steps between two choices of dt_L", static_cast<double>(adaptive.interval),
          "1 or more", "1500 makes the choices cost 4 % of a run.");
}

double choose_time_step(const AdaptiveTimeStep& adaptive, Sample& sample, AdaptiveTimeStepState& state) {
  if (state.time_step == 0.0 || state.steps >= adaptive.interval) {
    state.time_step = std::clamp(sample.stable_time_step(), adaptive.smallest, adaptive.largest);
    state.steps = 0;
  }
  return state.time_step;
}

}  // namespace flowslide
