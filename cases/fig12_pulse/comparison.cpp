// SPDX-License-Identifier: GPL-2.0-or-later
#include "comparison.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "experiment/windows.hpp"
#include "program/runout.hpp"

namespace flowslide {
namespace {

constexpr double apart = 0.1;       ///< relative difference of velocity at which RD counts as behind RI
constexpr double interval = 0.05;   ///< m, interval of x over which velocities are means
constexpr double common_place = 2.0;  ///< m, x at which the amplitudes are compared; every pulse still acts there

constexpr double compared = 3e3;  ///< Pa, amplitude at which the schemes are compared

double velocity_near(const Series& over_displacement, double place) {
  return mean_over(over_displacement, "velocity", place - 0.5 * interval, place + 0.5 * interval);
}

/// The slides of a scheme, by increasing amplitude of their pulse (Pa).
std::vector<SweepMember> amplitudes_of(const Ensembles& slides, const std::string& scheme) {
  return sweep_of(slides, scheme + "_", "amplitude");
}

/// v near the common place with the larger pulse / with the smaller pulse, median over the samples.
double growth(const Ensemble& smaller, const Ensemble& larger) {
  const auto velocity = [](const Result& result) {
    return velocity_near(windows_over(result, "displacement"), common_place);
  };
  std::vector<double> ratios;
  for (const auto& [a, b] : paired(smaller, larger)) ratios.push_back(velocity(*b) / velocity(*a));
  return statistics_of(ratios).median;
}

const Ensemble* at_amplitude(const std::vector<SweepMember>& sweep, double amplitude) {
  for (const SweepMember& member : sweep)
    if (member.parameter == amplitude) return member.ensemble;
  return nullptr;
}

void add_parting(const Ensemble& rd, const Ensemble& ri, std::map<std::string, double>& metrics) {
  std::vector<double> velocities;
  for (const auto& [a, b] : paired(rd, ri))
    velocities.push_back(parting_velocity(windows_over(*a, "displacement"), windows_over(*b, "displacement")));
  if (velocities.empty()) return;
  std::erase_if(velocities, [](double velocity) { return std::isnan(velocity); });
  const Statistics all = statistics_of(velocities);
  metrics["parting_velocity.median"] = all.median;
  metrics["parting_velocity.lowest"] = all.lowest;
  metrics["parting_velocity.highest"] = all.highest;
  metrics["RD_normal_stress_over_RI"] = paired_ratio(rd, ri, "liquefied_normal_stress").median;
  metrics["acceleration_gap"] = paired_difference(ri, rd, "acceleration_share").lowest;
}

void add_growth(const std::vector<SweepMember>& amplitudes, std::map<std::string, double>& metrics) {
  if (amplitudes.size() < 2) return;
  std::vector<double> growths;
  for (std::size_t i = 1; i < amplitudes.size(); ++i)
    growths.push_back(growth(*amplitudes[i - 1].ensemble, *amplitudes[i].ensemble));
  metrics["RI_growth"] = statistics_of(growths).lowest;
}

double range(const Statistics& all) { return all.highest - all.lowest; }

void add_spread(const std::vector<SweepMember>& amplitudes, std::map<std::string, double>& metrics) {
  if (amplitudes.size() < 2) return;
  std::map<const Result*, std::vector<double>> velocities;  // of each sample, by its result at the first amplitude
  for (const SweepMember& member : amplitudes)
    for (const auto& [sample, result] : paired(*amplitudes.front().ensemble, *member.ensemble))
      velocities[sample].push_back(metric_of(*result, "largest_velocity"));
  std::vector<double> over_amplitudes, over_samples;
  for (const auto& [sample, largest] : velocities)
    if (largest.size() == amplitudes.size()) over_amplitudes.push_back(range(statistics_of(largest)));
  for (const SweepMember& member : amplitudes)
    over_samples.push_back(range(statistics_of(*member.ensemble, "largest_velocity")));
  metrics["RD_spread_over_amplitudes"] = statistics_of(over_amplitudes).mean;
  metrics["RD_spread_over_seeds"] = statistics_of(over_samples).mean;
  metrics["RD_spread_ratio"] = metrics["RD_spread_over_amplitudes"] / metrics["RD_spread_over_seeds"];
}

}  // namespace

double parting_velocity(const Series& rd, const Series& ri) {
  const double end = std::min(end_of(rd), end_of(ri)) - interval;
  if (!(end > interval)) return std::numeric_limits<double>::quiet_NaN();
  double together = 0.0;
  bool parted = false;
  for (double place = interval; place < end; place += interval) {
    const double velocity = velocity_near(ri, place);
    parted = velocity_near(rd, place) < (1.0 - apart) * velocity;
    if (!parted) together = velocity;
  }
  return parted ? together : std::numeric_limits<double>::quiet_NaN();
}

void compare_schemes(const Ensembles& slides, std::map<std::string, double>& metrics) {
  const auto rd = amplitudes_of(slides, "RD"), ri = amplitudes_of(slides, "RI");
  const Ensemble *rd_compared = at_amplitude(rd, compared), *ri_compared = at_amplitude(ri, compared);
  if (rd_compared != nullptr && ri_compared != nullptr) add_parting(*rd_compared, *ri_compared, metrics);
  add_growth(ri, metrics);
  add_spread(rd, metrics);
}

}  // namespace flowslide
