// SPDX-License-Identifier: GPL-2.0-or-later
#include "critical_conductivity.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <list>
#include <vector>

namespace flowslide {
namespace {

constexpr double lost_share = 0.5;  ///< limit of |v/v(k = 0) - 1|: half way between sliding as at k = 0 and standing
constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

std::vector<double> parameters_of(const std::vector<SweepMember>& sweep) {
  std::vector<double> parameters;
  for (const SweepMember& member : sweep) parameters.push_back(member.parameter);
  return parameters;
}

/// The sweep of one sample, as ensembles of one result. The ensembles are stored in `kept`, which must outlive the
/// sweep.
std::vector<SweepMember> sweep_on_sample(const std::vector<SweepMember>& sweep, const Result& first,
                                         std::list<Ensemble>& kept) {
  std::vector<SweepMember> own;
  const Ensemble reference{first};
  for (const SweepMember& member : sweep)
    for (const auto& [a, result] : paired(reference, *member.ensemble))
      own.push_back({member.parameter, &kept.emplace_back(Ensemble{*result})});
  return own;
}

std::vector<SweepMember> sweep_over_k(const Ensembles& slides, const char* prefix) {
  return sweep_of(slides, prefix, "hydraulic_conductivity");
}

/// |v/v(k = 0) - 1| for the median velocities at the end of the pulse; NaN without k = 0.
std::vector<double> changes(const std::vector<SweepMember>& sweep) {
  std::vector<double> all = medians_along(sweep, "velocity_after_pulse");
  const double first = sweep.empty() || sweep.front().parameter != 0.0 ? undefined : all.front();
  for (double& value : all) value = std::abs(value / first - 1.0);
  return all;
}

void add_critical(const std::vector<SweepMember>& sweep, std::map<std::string, double>& metrics) {
  std::vector<double> middles, bounds;
  if (sweep.empty()) return;
  for (const Result& first : *sweep.front().ensemble) {
    const auto [lower, upper] = critical_conductivity(sweep, first);
    if (std::isnan(lower)) continue;
    const double highest = std::isnan(upper) ? std::numeric_limits<double>::infinity() : upper;
    middles.push_back(lower > 0.0 ? std::sqrt(lower * highest) : 0.0);
    bounds.insert(bounds.end(), {lower, highest});
  }
  if (middles.empty() || !std::isfinite(statistics_of(middles).median)) return;
  metrics["critical_conductivity"] = statistics_of(middles).median;
  metrics["critical_conductivity_lower"] = statistics_of(bounds).lowest;
  metrics["critical_conductivity_upper"] = statistics_of(bounds).highest;
}

}  // namespace

CriticalConductivity critical_conductivity(const std::vector<SweepMember>& sweep, const Result& first) {
  std::list<Ensemble> kept;
  const auto own = sweep_on_sample(sweep, first, kept);
  const std::vector<double> change = changes(own);
  CriticalConductivity critical{undefined, undefined};
  for (std::size_t i = 0; i < own.size() && change[i] <= lost_share; ++i) critical.lower = own[i].parameter;
  for (std::size_t i = own.size(); i-- > 0 && change[i] > lost_share;) critical.upper = own[i].parameter;
  return critical;
}

void compare_conductivities(const Ensembles& slides, std::map<std::string, double>& metrics) {
  const auto rd = sweep_over_k(slides, "RD_"), ri = sweep_over_k(slides, "RI_");
  metrics["RD_velocity_order"] = rank_correlation(parameters_of(rd), medians_along(rd, "largest_velocity"));
  metrics["RD_runout_order"] = rank_correlation(parameters_of(rd), medians_along(rd, "runout"));
  add_critical(ri, metrics);
  if (!metrics.contains("critical_conductivity")) return;
  const std::vector<double> change = changes(ri);
  double below = undefined, stopped = undefined;
  for (std::size_t i = 0; i < ri.size(); ++i) {
    const double k = ri[i].parameter;
    if (k > 0.0 && k < metrics.at("critical_conductivity")) below = std::fmax(below, change[i]);
    if (k >= metrics.at("critical_conductivity_upper"))
      stopped = std::fmin(stopped, statistics_of(*ri[i].ensemble, "stands").mean);
  }
  metrics["RI_change_below"] = below;
  metrics["RI_stopped_above"] = stopped;
}

Series critical_series(const Ensembles& slides) {
  std::map<std::string, double> metrics;
  add_critical(sweep_over_k(slides, "RI_"), metrics);
  Series series;
  series.axis = {"critical_conductivity", "k", "m/s", "critical hydraulic conductivity by RI", "", {}};
  series.columns = {{"lower", "k", "m/s", "its lower bound", "", {}}, {"upper", "k", "m/s", "its upper bound", "", {}}};
  if (metrics.empty()) return series;
  const std::array bounds{metrics.at("critical_conductivity_lower"), metrics.at("critical_conductivity_upper")};
  if (std::isfinite(bounds[1])) series.append_row(metrics.at("critical_conductivity"), bounds);
  return series;
}

}  // namespace flowslide
