// SPDX-License-Identifier: GPL-2.0-or-later
#include "app/runout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace flowslide {
namespace {

constexpr double peak_before = 0.02;      ///< strain within which a loose sample has its peak
constexpr double velocity_window = 0.1;   ///< s: grains make the velocity swing
constexpr double stress_window = 0.02;    ///< s: of the normal stress, which swings faster
constexpr int coarse_rows = 25;
constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

double peak_shear_stress(const Series& series) {
  const auto &strain = series.column("shear_strain").values, &stress = series.column("shear_stress").values;
  double largest = stress.front();
  for (std::size_t row = 0; row < series.rows() && strain[row] <= peak_before; ++row)
    largest = std::max(largest, stress[row]);
  return largest;
}

/// The means of a column over windows (s) that overlap by half, to the end of the record.
std::vector<double> running_means(const Series& series, const std::string& column, double window) {
  std::vector<double> means;
  for (double from = 0.0; from + window <= series.axis.values.back(); from += 0.5 * window)
    means.push_back(mean_between(series, column, "time", from, from + window));
  if (means.empty()) throw std::invalid_argument("the record of a runout is shorter than a tenth of a second");
  return means;
}

double velocity_after(const Series& series, double duration, bool stopped) {
  const double from = duration - 0.5 * velocity_window, to = duration + 0.5 * velocity_window;
  if (series.axis.values.back() >= to) return mean_between(series, "velocity", "time", from, to);
  return stopped ? 0.0 : nothing;
}

/// Rank of each value, from 1; equal values share the mean of theirs.
std::vector<double> ranks_of(const std::vector<double>& values) {
  std::vector<double> ranks;
  for (const double value : values) {
    const auto below = std::count_if(values.begin(), values.end(), [&](double v) { return v < value; });
    const auto equal = std::count(values.begin(), values.end(), value);
    ranks.push_back(static_cast<double>(below) + 0.5 * static_cast<double>(equal + 1));
  }
  return ranks;
}

Column column_like(const Ensemble& ensemble, const std::string& metric, const std::string& name) {
  const auto& all = ensemble.front().metrics;
  const auto found = std::find_if(all.begin(), all.end(), [&](const Metric& m) { return m.name == metric; });
  if (found == all.end()) throw std::invalid_argument("a slide has no metric " + metric);
  return {name, name, found->units, found->long_name, "", {}};
}

}  // namespace

std::vector<Metric> pulse_runout(const SlideOutcome& outcome) {
  const auto* pulse = std::get_if<SinePulse>(&outcome.point.settings.loading);
  if (pulse == nullptr) throw std::invalid_argument("the loading of a runout must be a pulse: set its history so");
  const Series& series = outcome.series;
  const bool stopped = outcome.stop == Stop::sliding_stopped;
  const auto velocities = running_means(series, "velocity", velocity_window);
  const auto stresses = running_means(series, "normal_stress", stress_window);
  return {{"peak_shear_stress", peak_shear_stress(series), "Pa", "largest shear stress up to 2 % strain"},
          {"lowest_normal_stress", *std::min_element(stresses.begin(), stresses.end()), "Pa",
           "least normal stress, as a mean over 0.02 s"},
          {"largest_velocity", *std::max_element(velocities.begin(), velocities.end()), "m/s",
           "largest sliding velocity, as a mean over 0.1 s"},
          {"velocity_after_pulse", velocity_after(series, pulse->duration, stopped), "m/s",
           "sliding velocity when the pulse ends"},
          {"runout", series.column("displacement").values.back(), "m", "sliding distance at the end"},
          {"sliding_stopped", stopped ? 1.0 : 0.0, "1", "1 if sliding has stopped"},
          {"sliding_time", series.axis.values.back(), "s", "time at the end"}};
}

std::vector<SweepMember> sweep_of(const Ensembles& slides, const std::string& prefix) {
  std::vector<SweepMember> sweep;
  for (const auto& [name, ensemble] : slides)
    if (name.starts_with(prefix)) sweep.push_back({std::stod(name.substr(prefix.size())), &ensemble});
  std::sort(sweep.begin(), sweep.end(),
            [](const SweepMember& a, const SweepMember& b) { return a.parameter < b.parameter; });
  return sweep;
}

std::vector<double> medians_along(const std::vector<SweepMember>& sweep, const std::string& metric) {
  std::vector<double> medians;
  for (const SweepMember& member : sweep) {
    const std::vector<double> values = values_of(*member.ensemble, metric);
    medians.push_back(values.empty() ? nothing : statistics_of(values).median);
  }
  return medians;
}

double rank_correlation(const std::vector<double>& first, const std::vector<double>& second) {
  const std::vector<double> x = ranks_of(first), y = ranks_of(second);
  const double middle = 0.5 * static_cast<double>(x.size() + 1);
  const auto moment = [&](const std::vector<double>& a, const std::vector<double>& b) {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0, std::plus<>(),
                              [&](double u, double v) { return (u - middle) * (v - middle); });
  };
  return moment(x, y) / std::sqrt(moment(x, x) * moment(y, y));
}

Series coarse_band(const Ensemble& ensemble) { return band_over(ensemble, "displacement", coarse_rows); }

Series sweep_series(Column axis, const std::vector<std::pair<std::string, std::vector<SweepMember>>>& schemes,
                    const std::vector<std::string>& metrics) {
  Series series;
  series.axis = std::move(axis);
  const auto member = [](const std::vector<SweepMember>& sweep, double parameter) {
    return std::find_if(sweep.begin(), sweep.end(), [&](const SweepMember& m) { return m.parameter == parameter; });
  };
  for (const SweepMember& candidate : schemes.front().second)
    if (std::all_of(schemes.begin(), schemes.end(),
                    [&](const auto& s) { return member(s.second, candidate.parameter) != s.second.end(); }))
      series.axis.values.push_back(candidate.parameter);
  if (series.axis.values.empty()) return series;
  for (const auto& [scheme, sweep] : schemes)
    for (const std::string& metric : metrics) {
      const std::string name = fmt::format("{}_{}", scheme, metric);
      Column median = column_like(*sweep.front().ensemble, metric, name + "_median"),
             lowest = column_like(*sweep.front().ensemble, metric, name + "_lowest"),
             highest = column_like(*sweep.front().ensemble, metric, name + "_highest");
      for (const double parameter : series.axis.values) {
        const Statistics all = statistics_of(values_of(*member(sweep, parameter)->ensemble, metric));
        median.values.push_back(all.median);
        lowest.values.push_back(all.lowest);
        highest.values.push_back(all.highest);
      }
      series.columns.insert(series.columns.end(), {median, lowest, highest});
    }
  return series;
}

}  // namespace flowslide
