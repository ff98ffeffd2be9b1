// SPDX-License-Identifier: GPL-2.0-or-later
// The data from which metrics are computed. They are gathered at every exchange between slope and sample, so metrics do
// not depend on which rows are kept.
#pragma once
#include <limits>
#include <string>
#include <vector>

#include "coupling/slide.hpp"
#include "experiment/windows.hpp"

namespace flowslide {

/// The largest tau up to a given shear strain. A loose sample becomes unstable there.
struct StressPeak {
  double stress = 0.0;          ///< tau, Pa
  double normal = 0.0;          ///< sigma at the peak, Pa
  double strain = 0.0;          ///< shear strain at the peak
  double time = 0.0;            ///< time of the peak, s
  double largest_number = 0.0;  ///< largest inertial number of the slope up to the peak
};

/// The multiple of `distance` that follows `value`, minus 1e-9 `distance`. This margin allows for the rounding of a
/// clock that is computed as a product.
double next_multiple(double value, double distance);

/// Inertial number I at a strain rate (1/s) and a mean stress (Pa). A mean stress below 1e-6 Pa counts as 1e-6 Pa.
double number_at(double rate, double mean_stress, const GrainScale& grains);

/// The data of one run from which metrics are computed.
struct RunMeasures {
  Series over_time, over_strain, over_displacement;  ///< means over windows (see mean_over); no columns: none gathered
  StressPeak peak_to_2, peak_to_5;                   ///< up to 2 % and up to 5 % strain
  double lowest_normal_stress = 0.0;                 ///< up to 50 % strain, Pa

  /// The windows that have columns, for a result.
  std::vector<Series> windows() const;
};

/// Measures of a run that is given as rows, such as an element test with rows at fixed strains.
RunMeasures measures_of_rows(const Series& rows);

/// Gathers the measures of a slide. A record that is restored together with its slide continues bit for bit. Means over
/// time and over displacement use every global step. Means over strain use only the steps in which the sample was
/// sheared, joined by straight lines: between them eq. 18 holds the stress, which lags behind the strain of the slope.
struct ExchangeRecord {
  /// `mean_stress_interval`: time between two measurements of p, s. Without it no inertial numbers are gathered.
  explicit ExchangeRecord(const GrainScale& grains = {},
                          double mean_stress_interval = std::numeric_limits<double>::infinity());

  /// Adds the state of the slide. Call it at the start of a slide and after each global step.
  void take(const Slide& slide);
  /// Updates only the peaks and the lowest sigma. Arguments: time (s), shear strain, tau and sigma (Pa), inertial
  /// number of the slope.
  void take_peaks(double time, double strain, const BasalStress& stress, double number);
  RunMeasures measures() const;
  /// Continues from the record in a checkpoint of the same slide. Throws std::invalid_argument if its windows differ.
  void restore(const ExchangeRecord& kept);

  GrainScale grains;
  double mean_stress_interval;
  WindowRecord over_time, over_strain, over_displacement;
  StressPeak peak_to_2, peak_to_5;
  double lowest_normal_stress = 0.0;
  std::int64_t taken = 0;          ///< number of states taken so far
  std::int64_t strained_steps = 0; ///< local steps of the sample at the last state in the means over strain
  double largest_strain = 0.0;     ///< largest shear strain so far
  double largest_number = 0.0;     ///< largest inertial number of the slope so far
  double mean_stress = 0.0;        ///< p as last measured, Pa
  double mean_stress_time = -1.0;  ///< time of that measurement, s
  double next_mean_stress = 0.0;   ///< time of the next measurement, s

 private:
  bool has_numbers() const;
};

/// Calls `visit(name, member)` for every number of a record except those of its windows. Writing and reading
/// checkpoints share this list.
template <typename Record, typename Visit>
void for_each_number_of(Record& record, Visit&& visit) {
  const auto peak = [&](const std::string& name, auto& member) {
    visit((name + "_stress").c_str(), member.stress);
    visit((name + "_normal").c_str(), member.normal);
    visit((name + "_strain").c_str(), member.strain);
    visit((name + "_time").c_str(), member.time);
    visit((name + "_largest_number").c_str(), member.largest_number);
  };
  peak("peak_to_2", record.peak_to_2);
  peak("peak_to_5", record.peak_to_5);
  visit("lowest_normal_stress", record.lowest_normal_stress);
  visit("taken", record.taken);
  visit("strained_steps", record.strained_steps);
  visit("largest_strain", record.largest_strain);
  visit("largest_number", record.largest_number);
  visit("mean_stress", record.mean_stress);
  visit("mean_stress_time", record.mean_stress_time);
  visit("next_mean_stress", record.next_mean_stress);
}

}  // namespace flowslide
