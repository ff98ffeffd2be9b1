// SPDX-License-Identifier: GPL-2.0-or-later
#include "coupling/liquefied_rest.hpp"

#include "grains/require.hpp"

namespace flowslide {

void validate(const LiquefiedRest& rest) {
  require(rest.normal_stress > 0.0, "normal stress of a sample that rests", rest.normal_stress, "> 0 Pa",
          "A thousandth of sigma_0 is liquefied.");
  require(rest.probed_strain > 0.0, "strain of a probe", rest.probed_strain, "> 0", "Give one such as 1 %.");
  require(rest.rested_strain > 0.0, "strain between probes", rest.rested_strain, "> 0", "Give one such as 10 %.");
}

bool rests(const LiquefiedRest& rest, RestState& state, double strain, double normal_stress) {
  if (!(normal_stress <= rest.normal_stress)) {
    state = {};
    return false;
  }
  if (state.probed < rest.probed_strain) {
    state.probed += strain;
    return false;
  }
  state.rested += strain;
  if (state.rested >= rest.rested_strain) state = {};
  return true;
}

}  // namespace flowslide
