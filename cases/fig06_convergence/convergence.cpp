// SPDX-License-Identifier: GPL-2.0-or-later
#include "convergence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace flowslide {
namespace {

constexpr double peak_before = 0.02;  ///< strain within which a loose sample has its peak
constexpr double compared_to = 5e-3;  ///< strain to which curves are compared
constexpr int windows = 20;
constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// Means of a column over windows of an abscissa from 0 to `end`; empty if the record ends before.
std::vector<double> means_of(const Series& series, const char* column, const char* abscissa, double end) {
  if (series.column(abscissa).values.back() < end) return {};
  std::vector<double> means;
  means.reserve(windows);
  for (int window = 0; window < windows; ++window)
    means.push_back(mean_between(series, column, abscissa, end * window / windows, end * (window + 1) / windows));
  return means;
}

std::vector<double> stresses(const Series& series) {
  return means_of(series, "shear_stress", "shear_strain", compared_to);
}

double sum_of_squares(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return sum;
}

/// Root mean square of the difference over that of the reference; NaN if one has no values.
double relative_difference(std::vector<double> values, const std::vector<double>& reference) {
  if (values.empty() || reference.empty()) return nothing;
  for (int window = 0; window < windows; ++window) values[window] -= reference[window];
  return std::sqrt(sum_of_squares(values) / sum_of_squares(reference));
}

/// Errors of the slides of one passing at I = 1e-2, by dt_G from large to small, and the slides themselves.
using Errors = std::map<double, double, std::greater<>>;
using Slides = std::map<double, const Ensemble*, std::greater<>>;

struct SlideName {
  std::string passing, level, time_step;
};

SlideName parts_of(const std::string& name) {
  const auto first = name.find('_'), last = name.rfind('_');
  if (first == last) return {name.substr(0, first), name.substr(first + 1), ""};
  return {name.substr(0, first), name.substr(first + 1, last - first - 1), name.substr(last + 1)};
}

/// Of the replicates that have been run alone as well.
std::vector<double> errors_of(const Ensemble& ensemble, const Ensemble& alone) {
  std::vector<double> errors;
  for (const Result& result : ensemble)
    for (const Result& reference : alone)
      if (result.provenance.replicate == reference.provenance.replicate)
        errors.push_back(relative_error(result.series, reference.series));
  std::erase_if(errors, [](double error) { return std::isnan(error); });
  return errors;
}

double least_ratio(const Errors& errors) {
  double least = std::numeric_limits<double>::infinity(), before = nothing;
  for (const auto& [time_step, error] : errors) {
    if (!std::isnan(before)) least = std::min(least, error / before);
    before = error;
  }
  return least;
}

double median(const std::vector<double>& values) { return values.empty() ? nothing : statistics_of(values).median; }

/// Between v(t) of two slides on the same samples, as far as both go.
double velocity_change(const Ensemble& slides, const Ensemble& references) {
  std::vector<double> changes;
  for (const Result& a : slides)
    for (const Result& b : references) {
      if (a.provenance.replicate != b.provenance.replicate) continue;
      const double end = std::min(a.series.axis.values.back(), b.series.axis.values.back());
      changes.push_back(relative_difference(means_of(a.series, "velocity", "time", end),
                                            means_of(b.series, "velocity", "time", end)));
    }
  return median(changes);
}

void compare_passings(const std::map<std::string, Errors>& high, double spread,
                      std::map<std::string, double>& metrics) {
  const auto whole = high.find("RI");
  for (const auto& [passing, errors] : high) {
    double largest = 0.0;
    for (const auto& [time_step, error] : errors) largest = std::max(largest, error);
    metrics[passing + "_largest_over_spread"] = largest / spread;
    if (errors.size() > 1) {
      metrics[passing + "_growth"] = errors.rbegin()->second / errors.begin()->second;
      metrics[passing + "_least_growth"] = least_ratio(errors);
    }
    if (whole == high.end() || passing == "RI") continue;
    double advantage = std::numeric_limits<double>::infinity();
    for (const double time_step : {1e-5, 1e-6})
      if (errors.contains(time_step) && whole->second.contains(time_step))
        advantage = std::min(advantage, whole->second.at(time_step) / errors.at(time_step));
    metrics[passing + "_advantage"] = advantage;
  }
}

/// How far slides with another n_accum, "carry<n>", are from those with 10: the largest relative difference.
double n_accum_difference(const Ensembles& slides) {
  double largest = nothing;
  for (const auto& [name, ensemble] : slides) {
    const auto [passing, level, time_step] = parts_of(name);
    const auto first = slides.find(fmt::format("carry_{}_{}", level, time_step));
    if (!passing.starts_with("carry") || passing == "carry" || first == slides.end()) continue;
    for (const double difference : errors_of(ensemble, first->second)) largest = std::fmax(largest, difference);
  }
  return largest;
}

/// What is said of the slides of one passing at I = 1e-2, `slides`.
void compare_steps(const std::string& passing, const Slides& slides, const Ensembles& all,
                   std::map<std::string, double>& metrics) {
  if (slides.size() < 2) return;
  const Ensemble &largest = *slides.begin()->second, &smallest = *slides.rbegin()->second;
  metrics[passing + "_velocity_change"] = velocity_change(smallest, largest);
  if (passing == "RI" && all.contains("DEM_low") && all.contains("DEM_high"))
    metrics["RI_distance_to_low_over_high"] =
        median(errors_of(smallest, all.at("DEM_low"))) / median(errors_of(smallest, all.at("DEM_high")));
}

}  // namespace

std::vector<Metric> peak_metrics(const Series& series) {
  const auto &strain = series.column("shear_strain").values, &stress = series.column("shear_stress").values;
  std::size_t peak = 0;
  for (std::size_t row = 0; row < series.rows() && strain[row] <= peak_before; ++row)
    if (stress[row] > stress[peak]) peak = row;
  std::vector<Metric> metrics{{"peak_shear_stress", stress[peak], "Pa", "largest shear stress up to 2 % strain"},
                              {"strain_at_peak", strain[peak], "1", "shear strain at that stress"}};
  const bool is_slide = std::any_of(series.columns.begin(), series.columns.end(),
                                    [](const Column& column) { return column.name == "rate_applied"; });
  if (is_slide) {
    const auto mean = [&](const char* rate) { return mean_between(series, rate, "shear_strain", 0.0, compared_to); };
    metrics.push_back({"rate_share", mean("rate_applied") / mean("rate_asked"), "1",
                       "mean rate applied over the rate asked for, up to 0.5 % strain"});
  }
  return metrics;
}

double relative_error(const Series& series, const Series& reference) {
  return relative_difference(stresses(series), stresses(reference));
}

double relative_spread(const Ensemble& ensemble) {
  std::vector<double> deviations, means;
  for (int window = 0; window < windows; ++window) {
    std::vector<double> samples;
    for (const Result& result : ensemble)
      if (const auto all = stresses(result.series); !all.empty()) samples.push_back(all[window]);
    if (samples.size() < 2) return nothing;
    const Statistics all = statistics_of(samples);
    deviations.push_back(all.deviation);
    means.push_back(all.mean);
  }
  return std::sqrt(sum_of_squares(deviations) / sum_of_squares(means));
}

void compare_with_grains(const Ensembles& slides, std::map<std::string, double>& metrics) {
  std::map<std::string, Errors> high;
  std::map<std::string, Slides> fast;
  std::vector<double> low;
  for (const auto& [name, ensemble] : slides) {
    const auto [passing, level, time_step] = parts_of(name);
    if (passing == "DEM") metrics[name + ".spread"] = relative_spread(ensemble);
    const auto alone = slides.find("DEM_" + level);
    if (passing == "DEM" || alone == slides.end()) continue;
    const std::vector<double> errors = errors_of(ensemble, alone->second);
    if (errors.empty()) continue;
    const Statistics all = statistics_of(errors);
    metrics[name + ".error"] = all.median;
    metrics[name + ".error.highest"] = all.highest;
    metrics[name + ".error_over_spread"] = all.median / relative_spread(alone->second);
    if (level == "low") low.push_back(all.highest);
    if (level != "high") continue;
    high[passing][std::stod(time_step)] = all.median;
    fast[passing][std::stod(time_step)] = &ensemble;
  }
  if (!low.empty())
    metrics["largest_low_error_over_spread"] = *std::max_element(low.begin(), low.end()) / metrics["DEM_low.spread"];
  if (high.empty()) return;
  const double spread = metrics["DEM_high.spread"];
  compare_passings(high, spread, metrics);
  for (const auto& [passing, of_passing] : fast) compare_steps(passing, of_passing, slides, metrics);
  const auto whole = metrics.find("RI_velocity_change"), reset = metrics.find("reset_velocity_change");
  if (whole != metrics.end() && reset != metrics.end())
    metrics["velocity_change_of_RI_over_reset"] = whole->second / reset->second;
  metrics["n_accum_difference_over_spread"] = n_accum_difference(slides) / spread;
}

}  // namespace flowslide
