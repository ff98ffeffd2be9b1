// SPDX-License-Identifier: GPL-2.0-or-later
// Compares a slope on a sample with an element test of the same sample. Slides are named "<passing>_..."; the element
// tests are named "DEM_low" and "DEM_high". Inertial number, dt_G and n_accum are parameters of a slide. A slide is
// compared with the element test at its inertial number.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "experiment/ensemble.hpp"
#include "experiment/run_measures.hpp"

namespace flowslide {

/// Metrics of one run, slide or element test. NaN for a metric that the run does not have.
///   peak_shear_stress   Pa, largest tau up to 2 % strain
///   strain_at_peak      shear strain of the layer at this peak
///   rate_share          slides only: mean rate applied / mean rate asked for, up to 0.5 % strain
std::vector<Metric> peak_metrics(const RunMeasures& measures);

/// Relative difference of tau between a run and a reference: RMS of the difference / RMS of the reference. The RMS is
/// over the means in 20 windows of strain up to 0.5 %. This range contains the peak; beyond it the responses of grains
/// diverge by chance. NaN if one of the runs ends before.
double relative_error(const Result& result, const Result& reference);

/// Relative scatter of tau between the samples of an ensemble, over the same windows: RMS of the standard deviation /
/// RMS of the mean. NaN for fewer than two samples.
double relative_spread(const Ensemble& ensemble);

/// The first part of the name of a slide, which says how strain is passed: "RI" of "RI_high_1e-3".
std::string passing_of(const std::string& slide);

/// The element test at the inertial number of a slide: "DEM_low", "DEM_high", or "" if there is none.
std::string alone_of(const Ensemble& slide, const Ensembles& slides);

/// Adds metrics about several slides to `metrics`. "Error" is relative_error of a slide against its element test;
/// "spread" is relative_spread of the element tests. "High" slides are those at I = 1e-2.
///   <slide>.error                    median error of the replicates
///   <slide>.error.highest            highest error of the replicates
///   <slide>.error_over_spread        median error / spread
///   DEM_<level>.spread               spread
///   largest_low_error_over_spread    highest error of all slides at I = 1e-4 / spread
///   <passing>_growth                 high slides: error at the smallest dt_G / error at the largest dt_G
///   <passing>_least_growth           high slides: smallest ratio of the errors of neighbouring dt_G, that of the
///                                    smaller dt_G over that of the larger; > 1 if every error grows as dt_G decreases
///   <passing>_advantage              high slides: error of eq. 15 / error of this passing; the smaller of the values
///                                    at dt_G = 1e-5 s and 1e-6 s
///   <passing>_largest_over_spread    high slides: largest error / spread
///   RI_distance_to_low_over_high     eq. 15, high slide with the smallest dt_G: median error against DEM_low / median
///                                    error against DEM_high
///   <passing>_velocity_change        high slides: relative difference of v(t) between the largest and the smallest
///                                    dt_G, up to the end of the shorter record; median over the replicates
///   velocity_change_of_RI_over_reset ratio of RI_velocity_change to reset_velocity_change
///   n_accum_difference_over_spread   largest error of slides "carry<n>" against "carry" at the same inertial number
///                                    and dt_G / spread of DEM_high
void compare_with_grains(const Ensembles& slides, std::map<std::string, double>& metrics);

}  // namespace flowslide
