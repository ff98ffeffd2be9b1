// SPDX-License-Identifier: GPL-2.0-or-later
// Runout of a slope after a pulse: the numbers of one slide, and the order of several along a parameter (Figs. 13, 14).
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "experiment/ensemble.hpp"
#include "program/slide_case.hpp"

namespace flowslide {

inline constexpr double velocity_window = 0.1;  ///< s, over which velocities are means: grains make them swing

/// The largest mean of v over windows of 0.1 s that overlap by half, m/s, from windows over time. NaN for a record that
/// is shorter.
double largest_velocity(const Series& over_time);

/// Mean of v over 0.1 s about `time`, m/s; NaN if the record does not hold all of it.
double velocity_at(const Series& over_time, double time);

/// The numbers of one slide; one that it does not have is not a number.
///   peak_shear_stress     Pa, largest tau up to 2 % strain
///   lowest_normal_stress  Pa, least sigma, as a mean over 0.02 s: a liquefied sample has next to none
///   largest_velocity      m/s, largest mean of v over 0.1 s
///   velocity_after_pulse  m/s, mean of v over 0.1 s about t = T; 0 if sliding has stopped by then; of a pulse alone
///   runout                m, sliding distance at the end of the record
///   sliding_stopped       1 if v has fallen to 0 (see StopConditions), 0 if the slope slides on or was never set off
///   sliding_time          s, end of the record: when it stopped, or was left
std::vector<Metric> pulse_runout(const SlideOutcome& outcome);

/// Slides that differ by one parameter, those of one scheme.
struct SweepMember {
  double parameter = 0.0;              ///< of its results
  const Ensemble* ensemble = nullptr;  ///< its replicates
};

/// The slides whose name begins with `prefix` and whose results have the parameter (see parameter_of), in its order.
std::vector<SweepMember> sweep_of(const Ensembles& slides, const std::string& prefix, const std::string& parameter);

/// The medians of a metric along a sweep; NaN where no replicate has it.
std::vector<double> medians_along(const std::vector<SweepMember>& sweep, const std::string& metric);

/// Spearman's rank correlation of two lists of the same length, equal values sharing their mean rank: 1 if they rise
/// together, -1 if one falls as the other rises. NaN for fewer than two pairs, if all values of a list are equal, or if
/// one is not a number.
double rank_correlation(const std::vector<double>& first, const std::vector<double>& second);

/// A quantity for the key of a figure: "5×10^{−6}", "10^{−5}", "0".
std::string label_of_quantity(double value);

/// Median, lowest and highest of the replicates over the sliding distance (see band_over), as means over long
/// intervals: the effective stress of a slope that slides comes in bursts, and no figure could show each.
Series coarse_band(const Ensemble& ensemble);

/// Sweeps by several schemes as one table: `axis` takes the parameters of the first; for each scheme and metric the
/// columns "<scheme>_<metric>_median", "_lowest" and "_highest". Only parameters that all schemes have; a metric that
/// one of their slides lacks is left out.
Series sweep_series(Column axis, const std::vector<std::pair<std::string, std::vector<SweepMember>>>& schemes,
                    const std::vector<std::string>& metrics);

}  // namespace flowslide
