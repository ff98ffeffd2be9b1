// SPDX-License-Identifier: GPL-2.0-or-later
#include "program/runout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "record/gnuplot_table.hpp"
#include "run/legend.hpp"

namespace flowslide {
namespace {

constexpr double stress_window = 0.02;  ///< s; shorter, because sigma fluctuates faster than the velocity
constexpr double rounding = 1e-9;       ///< margin for the rounding of a number of windows
constexpr int coarse_rows = 25;
constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

/// Means of a column over windows that overlap by half, to the end of the record. `window`: length of a window, s. A
/// record that is shorter than a window has one mean, over all of it; a record without rows has none.
std::vector<double> running_means(const Series& over_time, const std::string& column, double window) {
  const double end = end_of(over_time);
  if (end <= 0.0) return {};
  const int halves = static_cast<int>(std::floor(2.0 * end / window + rounding));
  if (halves < 2) return {mean_over(over_time, column, 0.0, end)};
  std::vector<double> means;
  for (int half = 0; half + 2 <= halves; ++half)
    means.push_back(mean_over(over_time, column, 0.5 * window * half, 0.5 * window * (half + 2)));
  return means;
}

/// Rank of each value, from 1. Equal values share their mean rank.
std::vector<double> ranks_of(const std::vector<double>& values) {
  std::vector<double> ranks;
  for (const double value : values) {
    const auto below = std::count_if(values.begin(), values.end(), [&](double v) { return v < value; });
    const auto equal = std::count(values.begin(), values.end(), value);
    ranks.push_back(static_cast<double>(below) + 0.5 * static_cast<double>(equal + 1));
  }
  return ranks;
}

/// "as a mean over 0.1 s", or that the record is shorter.
std::string mean_text(const Series& over_time, double window) {
  if (2.0 * end_of(over_time) / window + rounding >= 2.0) return fmt::format("as a mean over {} s", window);
  return fmt::format("as a mean over all of the run, which is shorter than {} s", window);
}

bool all_have(const std::vector<SweepMember>& sweep, const std::string& metric) {
  return std::none_of(sweep.begin(), sweep.end(),
                      [&](const SweepMember& member) { return values_of(*member.ensemble, metric).empty(); });
}

Column column_like(const std::vector<SweepMember>& sweep, const std::string& metric, const std::string& name) {
  for (const SweepMember& member : sweep)
    for (const Result& result : *member.ensemble)
      for (const Metric& candidate : result.metrics)
        if (candidate.name == metric) return {name, name, candidate.units, candidate.long_name, "", {}};
  return {name, name, "1", metric, "", {}};
}

}  // namespace

double largest_velocity(const Series& over_time) {
  return statistics_of(running_means(over_time, "velocity", velocity_window)).highest;
}

double velocity_at(const Series& over_time, double time) {
  const double half = 0.5 * velocity_window, slack = rounding * velocity_window;
  if (!(time - half >= -slack && time + half <= end_of(over_time) + slack)) return undefined;
  return mean_over(over_time, "velocity", time - half, time + half);
}

std::vector<Metric> pulse_runout(const SlideOutcome& outcome) {
  const auto* pulse = std::get_if<SinePulse>(&outcome.point.settings.loading);
  const Series& over_time = outcome.measures.over_time;
  const bool stopped = outcome.stop == Stop::sliding_stopped;
  const auto& velocities = outcome.series.column("velocity").values;
  const double sliding = outcome.point.stop.sliding_velocity;  // infinite if not given
  const bool triggered = std::isinf(sliding) || *std::max_element(velocities.begin(), velocities.end()) > sliding;
  double after = pulse != nullptr ? velocity_at(over_time, pulse->duration) : undefined;
  if (pulse != nullptr && stopped && std::isnan(after)) after = 0.0;
  return {{"peak_shear_stress", outcome.measures.peak_to_2.stress, "Pa", "largest shear stress up to 2 % strain"},
          {"lowest_normal_stress", statistics_of(running_means(over_time, "normal_stress", stress_window)).lowest, "Pa",
           "least normal stress, " + mean_text(over_time, stress_window)},
          {"largest_velocity", largest_velocity(over_time), "m/s",
           "largest sliding velocity, " + mean_text(over_time, velocity_window)},
          {"velocity_after_pulse", after, "m/s", "sliding velocity when the pulse ends"},
          {"runout", outcome.series.last("displacement"), "m", "sliding distance at the end"},
          {"sliding_stopped", stopped ? 1.0 : 0.0, "1", "1 if sliding has stopped"},
          {"stands", stopped || !triggered ? 1.0 : 0.0, "1", "1 if sliding has stopped or was never triggered"},
          {"sliding_time", outcome.series.last("time"), "s", "time at the end"}};
}

std::vector<SweepMember> sweep_of(const Ensembles& slides, const std::string& prefix, const std::string& parameter) {
  std::vector<SweepMember> sweep;
  for (const auto& [name, ensemble] : slides)
    if (const double value = parameter_of(ensemble, parameter); name.starts_with(prefix) && std::isfinite(value))
      sweep.push_back({value, &ensemble});
  std::stable_sort(sweep.begin(), sweep.end(),
                   [](const SweepMember& a, const SweepMember& b) { return a.parameter < b.parameter; });
  return sweep;
}

std::vector<double> medians_along(const std::vector<SweepMember>& sweep, const std::string& metric) {
  std::vector<double> medians;
  for (const SweepMember& member : sweep) medians.push_back(statistics_of(*member.ensemble, metric).median);
  return medians;
}

double rank_correlation(const std::vector<double>& first, const std::vector<double>& second) {
  const auto is_nan = [](double value) { return std::isnan(value); };
  if (std::any_of(first.begin(), first.end(), is_nan) || std::any_of(second.begin(), second.end(), is_nan))
    return undefined;
  const std::vector<double> x = ranks_of(first), y = ranks_of(second);
  const double middle = 0.5 * static_cast<double>(x.size() + 1);
  const auto moment = [&](const std::vector<double>& a, const std::vector<double>& b) {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0, std::plus<>(),
                              [&](double u, double v) { return (u - middle) * (v - middle); });
  };
  return moment(x, y) / std::sqrt(moment(x, x) * moment(y, y));
}

std::string label_of_quantity(double value) {
  if (value == 0.0) return "0";
  const double exponent = std::floor(std::log10(std::abs(value)) + rounding), share = value / std::pow(10.0, exponent);
  const std::string power = fmt::format("10^{{{}{:.0f}}}", exponent < 0.0 ? "−" : "", std::abs(exponent));
  return std::abs(share - 1.0) < rounding ? power : fmt::format("{:.3g}×{}", share, power);
}

Series coarse_band(const Ensemble& ensemble) { return band_over(ensemble, "displacement", coarse_rows, BandEnd::most); }

Series sweep_series(Column axis, const std::vector<std::pair<std::string, std::vector<SweepMember>>>& schemes,
                    const std::vector<std::string>& metrics) {
  Series series;
  series.axis = std::move(axis);
  const auto member = [](const std::vector<SweepMember>& sweep, double parameter) {
    return std::find_if(sweep.begin(), sweep.end(), [&](const SweepMember& m) { return m.parameter == parameter; });
  };
  for (const SweepMember& candidate : schemes.front().second) {
    const bool known = !series.axis.values.empty() && candidate.parameter == series.axis.values.back();
    const auto has = [&](const auto& scheme) {
      return member(scheme.second, candidate.parameter) != scheme.second.end();
    };
    if (!known && std::all_of(schemes.begin(), schemes.end(), has)) series.axis.values.push_back(candidate.parameter);
  }
  for (const auto& [scheme, sweep] : schemes)
    for (const std::string& metric : metrics) {
      if (series.rows() > 0 && !all_have(sweep, metric)) continue;
      const std::string name = fmt::format("{}_{}", scheme, metric);
      Column median = column_like(sweep, metric, name + "_median"),
             lowest = column_like(sweep, metric, name + "_lowest"),
             highest = column_like(sweep, metric, name + "_highest");
      for (const double parameter : series.axis.values) {
        const Statistics all = statistics_of(*member(sweep, parameter)->ensemble, metric);
        median.values.push_back(all.median);
        lowest.values.push_back(all.lowest);
        highest.values.push_back(all.highest);
      }
      series.columns.insert(series.columns.end(), {median, lowest, highest});
    }
  return series;
}

void write_sweep(const OutputFolder& output, const std::string& case_name, const Ensembles& slides,
                 const SweepFigure& figure) {
  Legend legend;
  for (const auto& [name, ensemble] : slides) {
    if (!SlideCase::are_slides(ensemble)) continue;
    write_table(output.file(name + "_coarse.dat"), {{{"case", case_name}, {"slide", name}}, coarse_band(ensemble)});
    legend.add(name, figure.label(parameter_of(ensemble, figure.axis.name)));
  }
  const auto over_parameter = [&](const char* prefix) { return sweep_of(slides, prefix, figure.axis.name); };
  const Series sweep =
      sweep_series(figure.axis, {{"RD", over_parameter("RD_")}, {"RI", over_parameter("RI_")}}, figure.metrics);
  write_table(output.file("sweep.dat"), {{{"case", case_name}}, sweep});
  legend.write(output);
}

}  // namespace flowslide
