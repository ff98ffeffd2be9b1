// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <map>
#include <string>

#include "experiment/ensemble.hpp"

namespace flowslide {

/// Compares the mobility of the slides "RD_e0_<n>" and "RI_e0_<n>" for n = 790, 771, 765 and 751. Adds these metrics to
/// `metrics`. Shares are ratios of medians over the replicates, since the void ratios have samples of their own; RD and
/// RI are compared on the samples that both use. NaN for slides without results.
///   <scheme>_<n>_velocity_share   v_max / v_max of <scheme>_e0_790
///   <scheme>_<n>_runout_share     runout / runout of <scheme>_e0_790
///   RD_<n>_velocity_over_RI, RD_<n>_runout_over_RI   RD / RI on the same sample, median over the samples
///   <n>_largest_runout            m, largest runout of all replicates of both schemes
///   <n>_runout_difference         m, |RD - RI on the same sample|, the largest difference
void compare_void_ratios(const Ensembles& slides, std::map<std::string, double>& metrics);

}  // namespace flowslide
