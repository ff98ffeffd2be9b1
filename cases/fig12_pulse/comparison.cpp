// SPDX-License-Identifier: GPL-2.0-or-later
#include "comparison.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flowslide {
namespace {

constexpr double apart = 0.1;       ///< share of RI's velocity by which RD's is visibly another
constexpr double interval = 0.05;   ///< m, of x: velocities are means over it
constexpr double common_place = 2.0;  ///< m, where the amplitudes are compared: beyond the pulse for none of them

double farthest(const Series& series) {
  const auto& x = series.column("displacement").values;
  return *std::max_element(x.begin(), x.end());
}

double velocity_near(const Series& series, double place) {
  return mean_between(series, "velocity", "displacement", place - 0.5 * interval, place + 0.5 * interval);
}

/// The ensembles of a scheme, by amplitude in kPa.
std::map<double, const Ensemble*> amplitudes_of(const Ensembles& slides, const std::string& scheme) {
  std::map<double, const Ensemble*> found;
  for (const auto& [name, ensemble] : slides)
    if (name.starts_with(scheme + "_") && name.ends_with("kPa"))
      found[std::stod(name.substr(scheme.size() + 1))] = &ensemble;
  return found;
}

double median_velocity_near(const Ensemble& ensemble, double place) {
  std::vector<double> velocities;
  for (const Result& result : ensemble) velocities.push_back(velocity_near(result.series, place));
  return statistics_of(velocities).median;
}

/// Results of both ensembles by replicate.
std::vector<std::pair<const Result*, const Result*>> pairs_of(const Ensemble& first, const Ensemble& second) {
  std::vector<std::pair<const Result*, const Result*>> pairs;
  for (const Result& a : first)
    for (const Result& b : second)
      if (a.provenance.replicate == b.provenance.replicate) pairs.emplace_back(&a, &b);
  return pairs;
}

void add_parting(const Ensemble& rd, const Ensemble& ri, std::map<std::string, double>& metrics) {
  std::vector<double> velocities;
  for (const auto& [a, b] : pairs_of(rd, ri)) velocities.push_back(parting_velocity(a->series, b->series));
  if (velocities.empty()) return;
  const Statistics all = statistics_of(velocities);
  metrics["parting_velocity.median"] = all.median;
  metrics["parting_velocity.lowest"] = all.lowest;
  metrics["parting_velocity.highest"] = all.highest;
  const auto values = [](const Ensemble& ensemble, const char* metric) {
    return values_of(ensemble, metric).empty() ? Statistics{} : statistics_of(values_of(ensemble, metric));
  };
  metrics["RD_normal_stress_over_RI"] =
      values(rd, "liquefied_normal_stress").median / values(ri, "liquefied_normal_stress").median;
  metrics["acceleration_gap"] = values(ri, "acceleration_share").lowest - values(rd, "acceleration_share").highest;
}

void add_growth(const std::map<double, const Ensemble*>& amplitudes, std::map<std::string, double>& metrics) {
  double growth = std::numeric_limits<double>::infinity(), before = std::numeric_limits<double>::quiet_NaN();
  for (const auto& [amplitude, ensemble] : amplitudes) {
    const double velocity = median_velocity_near(*ensemble, common_place);
    if (!std::isnan(before)) growth = std::min(growth, velocity / before);
    before = velocity;
  }
  if (amplitudes.size() > 1) metrics["RI_growth"] = growth;
}

void add_spread(const std::map<double, const Ensemble*>& amplitudes, std::map<std::string, double>& metrics) {
  if (amplitudes.size() < 2) return;
  std::vector<double> medians, ranges;
  for (const auto& [amplitude, ensemble] : amplitudes) {
    const Statistics all = statistics_of(values_of(*ensemble, "largest_velocity"));
    medians.push_back(all.median);
    ranges.push_back(all.highest - all.lowest);
  }
  const Statistics over_amplitudes = statistics_of(medians);
  metrics["RD_spread_over_amplitudes"] = over_amplitudes.highest - over_amplitudes.lowest;
  metrics["RD_spread_over_seeds"] = statistics_of(ranges).mean;
  metrics["RD_spread_ratio"] = metrics["RD_spread_over_amplitudes"] / metrics["RD_spread_over_seeds"];
}

}  // namespace

double parting_velocity(const Series& rd, const Series& ri) {
  const double end = std::min(farthest(rd), farthest(ri)) - interval;
  double together = 0.0;
  for (double place = interval; place < end; place += interval) {
    const double velocity = velocity_near(ri, place);
    if (velocity_near(rd, place) >= (1.0 - apart) * velocity) together = velocity;
  }
  return together;
}

void compare_schemes(const Ensembles& slides, std::map<std::string, double>& metrics) {
  const auto rd = amplitudes_of(slides, "RD"), ri = amplitudes_of(slides, "RI");
  if (rd.contains(3.0) && ri.contains(3.0)) add_parting(*rd.at(3.0), *ri.at(3.0), metrics);
  add_growth(ri, metrics);
  add_spread(rd, metrics);
}

}  // namespace flowslide
