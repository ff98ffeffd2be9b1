// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <map>
#include <string>

#include "experiment/ensemble.hpp"

namespace flowslide {

/// What is said of RD_ramp against RI_ramp on the samples that both have, added to `metrics` if there are two or more:
///   path_difference_over_spread   of the stress paths up to the earliest peak: difference of tau and of sigma between
///                                 RD and RI on one sample over the standard deviation of RI between samples, both as
///                                 root mean squares over strain and samples; the larger of the two
///   peak_difference_over_spread   the same of the peaks of tau
///   velocity_ratio                median over the samples of RD's velocity over RI's at the same displacement, the
///                                 last that both reach: the schemes lose their balance a moment apart
///   linearity_gap                 lowest linearity_1 of RD (before liquefaction) less highest linearity_2 (after it)
///   inertial_number_ratio         median I beyond 50 % strain of RI, by the rate of the slope, over RD's
void compare_ramps(const Ensembles& slides, std::map<std::string, double>& metrics);

/// What is said of RD_hold against RI_hold beyond 50 % strain:
///   <what>_excess    mean of RD less mean of RI in standard errors of the difference, of steady_shear, steady_normal
///                    and steady_friction
///   <what>_ratio     mean of RD over mean of RI
void compare_steady_states(const Ensembles& slides, std::map<std::string, double>& metrics);

}  // namespace flowslide
