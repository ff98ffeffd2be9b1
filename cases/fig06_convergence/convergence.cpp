// SPDX-License-Identifier: GPL-2.0-or-later
#include "convergence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace flowslide {
namespace {

constexpr double compared_to = 5e-3;  ///< curves are compared up to this strain
constexpr int windows = 20;
constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

/// Means of a column over equal windows of an abscissa from 0 to `end`. Shape (windows); empty if the run ends before.
std::vector<double> means_of(const Result& result, const char* column, const char* abscissa, double end) {
  const Series& all = windows_over(result, abscissa);
  if (!(end_of(all) >= end && end > 0.0)) return {};
  std::vector<double> means;
  means.reserve(windows);
  for (int window = 0; window < windows; ++window)
    means.push_back(mean_over(all, column, end * window / windows, end * (window + 1) / windows));
  return means;
}

std::vector<double> stresses(const Result& result) {
  return means_of(result, "shear_stress", "shear_strain", compared_to);
}

double sum_of_squares(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return sum;
}

/// RMS of the difference / RMS of the reference; NaN if one of them is empty.
double relative_difference(std::vector<double> values, const std::vector<double>& reference) {
  if (values.empty() || reference.empty()) return undefined;
  for (int window = 0; window < windows; ++window) values[window] -= reference[window];
  return std::sqrt(sum_of_squares(values) / sum_of_squares(reference));
}

/// For the slides of one passing at I = 1e-2: dt_G, from large to small -> error or slide.
using Errors = std::map<double, double, std::greater<>>;
using Slides = std::map<double, const Ensemble*, std::greater<>>;

constexpr double rounding = 1e-9;  ///< relative difference by rounding between parameters that count as equal

bool same_parameter(const Ensemble& a, const Ensemble& b, const char* name) {
  const double one = parameter_of(a, name), other = parameter_of(b, name);
  return std::abs(one - other) <= rounding * std::abs(other);
}

/// Errors of the replicates whose sample also has an element test.
std::vector<double> errors_of(const Ensemble& ensemble, const Ensemble& alone) {
  std::vector<double> errors;
  for (const auto& [result, reference] : paired(ensemble, alone)) errors.push_back(relative_error(*result, *reference));
  std::erase_if(errors, [](double error) { return std::isnan(error); });
  return errors;
}

double least_ratio(const Errors& errors) {
  double least = std::numeric_limits<double>::infinity(), before = undefined;
  for (const auto& [time_step, error] : errors) {
    if (!std::isnan(before)) least = std::min(least, error / before);
    before = error;
  }
  return least;
}

/// Relative difference of v(t) between two slides up to the end of the shorter record; median over the replicates.
double velocity_change(const Ensemble& slides, const Ensemble& references) {
  std::vector<double> changes;
  for (const auto& [a, b] : paired(slides, references)) {
    const double end = std::min(end_of(windows_over(*a, "time")), end_of(windows_over(*b, "time")));
    changes.push_back(
        relative_difference(means_of(*a, "velocity", "time", end), means_of(*b, "velocity", "time", end)));
  }
  return statistics_of(changes).median;
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

/// Largest error of slides with another n_accum ("carry<n>") against those of "carry".
double n_accum_difference(const Ensembles& slides) {
  double largest = undefined;
  for (const auto& [name, ensemble] : slides) {
    if (!passing_of(name).starts_with("carry") || passing_of(name) == "carry") continue;
    for (const auto& [first_name, first] : slides)
      if (passing_of(first_name) == "carry" && same_parameter(ensemble, first, "time_step") &&
          same_parameter(ensemble, first, "inertial_number"))
        for (const double difference : errors_of(ensemble, first)) largest = std::fmax(largest, difference);
  }
  return largest;
}

/// Adds the metrics that compare different dt_G. `slides` are those of one passing at I = 1e-2.
void compare_steps(const std::string& passing, const Slides& slides, const Ensembles& all,
                   std::map<std::string, double>& metrics) {
  if (slides.size() < 2) return;
  const Ensemble &largest = *slides.begin()->second, &smallest = *slides.rbegin()->second;
  metrics[passing + "_velocity_change"] = velocity_change(smallest, largest);
  if (passing == "RI" && all.contains("DEM_low") && all.contains("DEM_high"))
    metrics["RI_distance_to_low_over_high"] = statistics_of(errors_of(smallest, all.at("DEM_low"))).median /
                                              statistics_of(errors_of(smallest, all.at("DEM_high"))).median;
}

}  // namespace

std::string passing_of(const std::string& slide) { return slide.substr(0, slide.find('_')); }

std::string alone_of(const Ensemble& slide, const Ensembles& slides) {
  for (const std::string name : {"DEM_low", "DEM_high"})
    if (slides.contains(name) && same_parameter(slide, slides.at(name), "inertial_number")) return name;
  return "";
}

std::vector<Metric> peak_metrics(const RunMeasures& measures) {
  const auto mean = [&](const char* rate) { return mean_over(measures.over_strain, rate, 0.0, compared_to); };
  return {{"peak_shear_stress", measures.peak_to_2.stress, "Pa", "largest shear stress up to 2 % strain"},
          {"strain_at_peak", measures.peak_to_2.strain, "1", "shear strain at that stress"},
          {"rate_share", mean("rate_applied") / mean("rate_asked"), "1",
           "mean rate applied over the rate asked for, up to 0.5 % strain"}};
}

double relative_error(const Result& result, const Result& reference) {
  return relative_difference(stresses(result), stresses(reference));
}

double relative_spread(const Ensemble& ensemble) {
  std::vector<double> deviations, means;
  for (int window = 0; window < windows; ++window) {
    std::vector<double> samples;
    for (const Result& result : ensemble)
      if (const auto all = stresses(result); !all.empty()) samples.push_back(all[window]);
    if (samples.size() < 2) return undefined;
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
    const std::string passing = passing_of(name), reference = alone_of(ensemble, slides);
    if (passing == "DEM") metrics[name + ".spread"] = relative_spread(ensemble);
    if (passing == "DEM" || reference.empty()) continue;
    const Ensemble& alone = slides.at(reference);
    const std::vector<double> errors = errors_of(ensemble, alone);
    if (errors.empty()) continue;
    const Statistics all = statistics_of(errors);
    metrics[name + ".error"] = all.median;
    metrics[name + ".error.highest"] = all.highest;
    metrics[name + ".error_over_spread"] = all.median / relative_spread(alone);
    if (reference == "DEM_low") low.push_back(all.highest);
    if (reference != "DEM_high") continue;
    const double time_step = parameter_of(ensemble, "time_step");
    high[passing][time_step] = all.median;
    fast[passing][time_step] = &ensemble;
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
