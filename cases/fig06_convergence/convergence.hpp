// SPDX-License-Identifier: GPL-2.0-or-later
// How far a slope on a sample is from the sample alone. Slides are named "<passing>_...", and the samples alone
// "DEM_low" and "DEM_high". Inertial number, dt_G and n_accum of a slide are its parameters: a slide is compared with
// the sample alone that is sheared at its inertial number.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "experiment/ensemble.hpp"
#include "experiment/run_measures.hpp"

namespace flowslide {

/// Of one run, slide or element test; what it does not have is not a number:
///   peak_shear_stress   Pa, largest tau up to 2 % strain
///   strain_at_peak      shear strain of the layer there
///   rate_share          of a slide: mean rate applied over the rate asked for, up to 0.5 % strain
std::vector<Metric> peak_metrics(const RunMeasures& measures);

/// Difference of tau between two runs over tau of the second: root mean squares over 20 windows of strain up to
/// 0.5 %, where the peak is and before the answers of grains part by chance; each value is a mean over its window. NaN
/// if one ends before that.
double relative_error(const Result& result, const Result& reference);

/// The same of the samples of an ensemble against their mean, with n - 1: the spread between samples. NaN for one.
double relative_spread(const Ensemble& ensemble);

/// The way to pass strain that a slide is named after: "RI" of "RI_high_1e-3".
std::string passing_of(const std::string& slide);

/// The sample alone that is sheared at the inertial number of a slide: "DEM_low", "DEM_high", or "" if there is none.
std::string alone_of(const Ensemble& slide, const Ensembles& slides);

/// Adds to `metrics`, from what has been run:
///   <slide>.error             against the sample alone at its inertial number, median over the replicates
///   <slide>.error.highest     the highest of them
///   <slide>.error_over_spread      its median over the spread between samples alone
///   DEM_<level>.spread        between the samples
///   largest_low_error_over_spread   of all at I = 1e-4, over the spread between samples
///   <passing>_growth          error at I = 1e-2 with the smallest dt_G over that with the largest
///   <passing>_least_growth    the least ratio of the errors of neighbouring dt_G, from large to small: > 1 if ordered
///   <passing>_advantage       the least ratio of the error by eq. 15 to that by this passing at dt_G = 1e-5 and 1e-6 s
///   <passing>_largest_over_spread   largest error at I = 1e-2 over the spread between samples
///   RI_distance_to_low_over_high   eq. 15 at I = 1e-2 with the smallest dt_G: difference to the sample alone at 1e-4
///                             over that to the sample alone at 1e-2, as relative errors, median over the replicates
///   <passing>_velocity_change      of v(t) at I = 1e-2 between the largest and the smallest dt_G, relative, as far as
///                             both go; velocity_change_of_RI_over_reset
///   n_accum_difference_over_spread  largest difference between passing "carry" and others ("carry<n>") at one inertial
///                             number and dt_G
void compare_with_grains(const Ensembles& slides, std::map<std::string, double>& metrics);

}  // namespace flowslide
