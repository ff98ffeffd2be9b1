// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <map>
#include <string>

#include "experiment/ensemble.hpp"

namespace flowslide {

/// Adds to `metrics` how mobile the slides "RD_e0_<n>" and "RI_e0_<n>" are, for n = 790, 771, 765, 751, as ratios of
/// the medians of their replicates; what was not run is not a number:
///   <scheme>_<n>_velocity_share   v_max over that of <scheme>_e0_790
///   <scheme>_<n>_runout_share     runout over that of <scheme>_e0_790
///   RD_<n>_velocity_over_RI, RD_<n>_runout_over_RI   RD over RI of one void ratio
///   <n>_largest_runout            m, the largest of all replicates that were run, of both schemes
///   <n>_runout_difference         m, between the medians of RD and RI
void compare_void_ratios(const Ensembles& slides, std::map<std::string, double>& metrics);

}  // namespace flowslide
