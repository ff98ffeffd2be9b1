// SPDX-License-Identifier: GPL-2.0-or-later
// What metrics are made of. It is gathered at every exchange between slope and sample, so that no metric depends on
// which rows are kept.
#pragma once
#include <limits>
#include <string>
#include <vector>

#include "coupling/slide.hpp"
#include "experiment/windows.hpp"

namespace flowslide {

/// The largest tau up to a shear strain: where a loose sample becomes unstable.
struct StressPeak {
  double stress = 0.0;          ///< tau, Pa
  double normal = 0.0;          ///< sigma there, Pa
  double strain = 0.0;          ///< shear strain there
  double time = 0.0;            ///< s
  double largest_number = 0.0;  ///< largest inertial number of the slope until then
};

/// The multiple of `distance` that follows `value`, less a billionth of it: a clock that is a product may miss it so.
double next_multiple(double value, double distance);

/// I of a rate (1/s) under a mean stress (Pa), which counts as 1e-6 Pa at least.
double number_at(double rate, double mean_stress, const GrainScale& grains);

/// What metrics read of one run.
struct RunMeasures {
  Series over_time, over_strain, over_displacement;  ///< windows, see mean_over; without columns where there are none
  StressPeak peak_to_2, peak_to_5;                   ///< up to 2 % and up to 5 % strain
  double lowest_normal_stress = 0.0;                 ///< up to 50 % strain, Pa

  /// Those of the windows that have columns, for a result.
  std::vector<Series> windows() const;
};

/// Measures of a run that is there as rows, such as an element test, whose rows stand at fixed strains.
RunMeasures measures_of_rows(const Series& rows);

/// Gathers the measures of a slide. Kept and restored with the slide, it goes on bit for bit. Means over time and over
/// displacement take every global step. Means over strain take the steps in which the sample was sheared, joined by
/// straight lines: the stress that eq. 18 holds in between lags behind the strain of the slope.
struct ExchangeRecord {
  /// Grains and the time between two measurements of p for the inertial numbers, s. Without it there are none of those.
  explicit ExchangeRecord(const GrainScale& grains = {},
                          double mean_stress_interval = std::numeric_limits<double>::infinity());

  /// At the start of a slide and after each global step.
  void take(const Slide& slide);
  /// The peaks alone: of a moment (s), strain, stresses (Pa) and inertial number of the slope.
  void take_peaks(double time, double strain, const BasalStress& stress, double number);
  RunMeasures measures() const;
  /// Goes on from what was kept of a record of the same slide. Throws std::invalid_argument if it has other windows.
  void restore(const ExchangeRecord& kept);

  GrainScale grains;
  double mean_stress_interval;
  WindowRecord over_time, over_strain, over_displacement;
  StressPeak peak_to_2, peak_to_5;
  double lowest_normal_stress = 0.0;
  std::int64_t taken = 0;          ///< how often it was called
  std::int64_t strained_steps = 0; ///< local steps of the sample when the means over strain took it last
  double largest_strain = 0.0;     ///< so far
  double largest_number = 0.0;     ///< of the slope so far
  double mean_stress = 0.0;        ///< p as last measured, Pa
  double mean_stress_time = -1.0;  ///< when, s
  double next_mean_stress = 0.0;   ///< when it is measured again, s

 private:
  bool has_numbers() const;
};

/// Every number of a record but those of its windows: calls `visit(name, member)`.
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
