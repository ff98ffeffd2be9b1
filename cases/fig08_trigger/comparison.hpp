// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <map>
#include <string>

#include "experiment/ensemble.hpp"

namespace flowslide {

/// Compares RD_ramp with RI_ramp on the samples that both use. Adds these metrics if there are at least two samples:
///   path_difference_over_spread   stress path up to the earliest peak: RMS difference between RD and RI on the same
///                                 sample / RMS standard deviation of RI between samples. The RMS is over strain (and
///                                 samples). It is computed for tau and for sigma; the larger value counts.
///   peak_difference_over_spread   the same ratio for the peaks of tau
///   velocity_ratio                velocity of RD / velocity of RI, median over the samples. It is taken at the same
///                                 displacement, just before the end of the shorter record, because the schemes become
///                                 unstable at slightly different times.
///   inertial_number_ratio         mean I beyond 50 % strain at the rate of the slope: RI / RD, median over the samples
void compare_ramps(const Ensembles& slides, std::map<std::string, double>& metrics);

/// Compares RD_hold with RI_hold beyond 50 % strain, on the samples that both use. <what> is shear, normal or friction,
/// for the metrics steady_shear, steady_normal and steady_friction:
///   <what>_excess    mean over the samples of RD - RI, in standard errors of this mean; from two samples on
///   <what>_ratio     RD / RI, median over the samples
void compare_steady_states(const Ensembles& slides, std::map<std::string, double>& metrics);

}  // namespace flowslide
