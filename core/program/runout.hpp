// SPDX-License-Identifier: GPL-2.0-or-later
// Runout of a slope after a pulse: the metrics of one slide, and several slides along a parameter (Figs. 13 and 14).
#pragma once
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "experiment/ensemble.hpp"
#include "program/slide_case.hpp"

namespace flowslide {

/// Averaging time of velocities, s. The grains make the velocity fluctuate.
inline constexpr double velocity_window = 0.1;

/// The largest mean of v over windows of 0.1 s that overlap by half, m/s. `over_time`: means over time (see
/// RunMeasures). A record that is shorter has one window, all of it; NaN for a record without rows.
double largest_velocity(const Series& over_time);

/// Mean of v over 0.1 s centred at `time` (s), m/s. NaN if the record does not cover this interval.
double velocity_at(const Series& over_time, double time);

/// The metrics of one slide; NaN for a metric that the slide does not have.
///   peak_shear_stress     Pa, largest tau up to 2 % strain
///   lowest_normal_stress  Pa, lowest mean of sigma over 0.02 s; close to 0 if the sample liquefies
///   largest_velocity      m/s, largest mean of v over 0.1 s
///   velocity_after_pulse  m/s, mean of v over 0.1 s centred at the end of the pulse; 0 if sliding stopped before;
///                         NaN for another loading
///   runout                m, sliding distance at the end of the record
///   sliding_stopped       1 if v fell to 0 (see StopConditions); 0 if the slope still slides or was never triggered
///   stands                1 if sliding has stopped, or if v never exceeded sliding_velocity (see StopConditions)
///   sliding_time          s, end of the record: sliding stopped, or the run ended
std::vector<Metric> pulse_runout(const SlideOutcome& outcome);

/// One slide of a sweep: slides of one scheme that differ by one parameter.
struct SweepMember {
  double parameter = 0.0;              ///< value of the parameter
  const Ensemble* ensemble = nullptr;  ///< replicates of the slide
};

/// The slides whose name begins with `prefix` and whose results have the parameter (see parameter_of), by increasing
/// parameter.
std::vector<SweepMember> sweep_of(const Ensembles& slides, const std::string& prefix, const std::string& parameter);

/// The median of a metric for each slide of a sweep; NaN where no replicate has the metric.
std::vector<double> medians_along(const std::vector<SweepMember>& sweep, const std::string& metric);

/// Spearman's rank correlation of two lists of the same length: 1 if both increase together, -1 if one decreases while
/// the other increases. Equal values share their mean rank. NaN for fewer than two pairs, if all values of a list are
/// equal, or if a value is NaN.
double rank_correlation(const std::vector<double>& first, const std::vector<double>& second);

/// A number for the legend of a figure, in gnuplot's markup: "5×10^{−6}", "10^{−5}", "0".
std::string label_of_quantity(double value);

/// Median, lowest and highest value of the replicates over the sliding distance, as far as more than half of them slide
/// (see BandEnd::most), as means over 25 intervals. The effective stress of a sliding slope comes in short bursts that
/// a figure cannot show one by one.
Series coarse_band(const Ensemble& ensemble);

/// Sweeps by several schemes as one table. The axis is filled with the parameters that all schemes have. For each
/// scheme and metric there are the columns "<scheme>_<metric>_median", "_lowest" and "_highest". A metric that one
/// slide of the scheme does not have is left out.
Series sweep_series(Column axis, const std::vector<std::pair<std::string, std::vector<SweepMember>>>& schemes,
                    const std::vector<std::string>& metrics);

/// A figure of RD and RI over one parameter.
struct SweepFigure {
  Column axis;                               ///< the parameter, without values
  std::vector<std::string> metrics;          ///< over the parameter, see sweep_series
  std::function<std::string(double)> label;  ///< legend of the slides with this value of the parameter
};

/// Writes the tables of such a figure: <slide>_coarse.dat for each slide (see coarse_band), sweep.dat (see
/// sweep_series) and legend.txt. Element tests among `slides` are left out.
void write_sweep(const OutputFolder& output, const std::string& case_name, const Ensembles& slides,
                 const SweepFigure& figure);

}  // namespace flowslide
