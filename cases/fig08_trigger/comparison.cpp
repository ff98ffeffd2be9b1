// SPDX-License-Identifier: GPL-2.0-or-later
#include "comparison.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "trigger_metrics.hpp"

namespace flowslide {
namespace {

constexpr int path_windows = 20;  ///< of strain up to the peak, over which stresses are means
constexpr double last_part = 0.9;  ///< of the displacement, from where on velocities are compared

struct Schemes {
  const Ensemble* rd = nullptr;
  const Ensemble* ri = nullptr;
};

Schemes schemes_of(const Ensembles& slides, const std::string& loading) {
  const auto rd = slides.find("RD_" + loading), ri = slides.find("RI_" + loading);
  if (rd == slides.end() || ri == slides.end()) return {};
  return {&rd->second, &ri->second};
}

/// RMS difference between RD and RI on one sample over the RMS deviation of RI between samples. Each row holds one
/// quantity, such as tau in one window of strain, for all samples.
double difference_over_spread(const std::vector<std::vector<double>>& rd, const std::vector<std::vector<double>>& ri) {
  double differences = 0.0, variances = 0.0;
  for (std::size_t row = 0; row < rd.size(); ++row) {
    const double deviation = statistics_of(ri[row]).deviation;
    variances += deviation * deviation;
    for (std::size_t sample = 0; sample < rd[row].size(); ++sample) {
      const double difference = rd[row][sample] - ri[row][sample];
      differences += difference * difference / static_cast<double>(rd[row].size());
    }
  }
  return std::sqrt(differences / variances);
}

std::vector<std::vector<double>> windows(const Ensemble& ensemble, const std::string& column, double end) {
  std::vector<std::vector<double>> rows;
  for (int window = 0; window < path_windows; ++window) {
    std::vector<double> samples;
    for (const Result& result : ensemble)
      samples.push_back(mean_between(result.series, column, "shear_strain", end * window / path_windows,
                                     end * (window + 1) / path_windows));
    rows.push_back(samples);
  }
  return rows;
}

double earliest_peak(const Ensemble& ensemble) {
  return statistics_of(values_of(ensemble, "strain_at_peak")).lowest;
}

double median(const Ensemble& ensemble, const std::string& metric) {
  const std::vector<double> values = values_of(ensemble, metric);
  return values.empty() ? std::numeric_limits<double>::quiet_NaN() : statistics_of(values).median;
}

/// Velocity by RD over that by RI near the last displacement that both reach.
double velocity_ratio(const Series& rd, const Series& ri) {
  const auto farthest = [](const Series& series) {
    const auto& x = series.column("displacement").values;
    return *std::max_element(x.begin(), x.end());
  };
  const double end = std::min(farthest(rd), farthest(ri));
  const auto velocity = [&](const Series& series) {
    return mean_between(series, "velocity", "displacement", last_part * end, end);
  };
  return velocity(rd) / velocity(ri);
}

}  // namespace

void compare_ramps(const Ensembles& slides, std::map<std::string, double>& metrics) {
  const auto [rd, ri] = schemes_of(slides, "ramp");
  if (rd == nullptr || rd->size() != ri->size() || rd->size() < 2) return;
  const double end = std::min(earliest_peak(*rd), earliest_peak(*ri));
  double path = 0.0;
  for (const char* column : {"shear_stress", "normal_stress"})
    path = std::max(path, difference_over_spread(windows(*rd, column, end), windows(*ri, column, end)));
  metrics["path_difference_over_spread"] = path;
  metrics["peak_difference_over_spread"] = difference_over_spread({values_of(*rd, "peak_shear_stress")},
                                                                  {values_of(*ri, "peak_shear_stress")});
  std::vector<double> ratios;
  for (std::size_t sample = 0; sample < rd->size(); ++sample)
    ratios.push_back(velocity_ratio((*rd)[sample].series, (*ri)[sample].series));
  metrics["velocity_ratio"] = statistics_of(ratios).median;
  const std::vector<double> before = values_of(*rd, "linearity_1"), after = values_of(*rd, "linearity_2");
  if (!before.empty() && !after.empty())
    metrics["linearity_gap"] = statistics_of(before).lowest - statistics_of(after).highest;
  metrics["inertial_number_ratio"] = median(*ri, "steady_inertial_number") / median(*rd, "steady_inertial_number");
}

void compare_steady_states(const Ensembles& slides, std::map<std::string, double>& metrics) {
  const auto [rd, ri] = schemes_of(slides, "hold");
  if (rd == nullptr) return;
  for (const std::string what : {"shear", "normal", "friction"}) {
    const std::vector<double> of_rd = values_of(*rd, "steady_" + what), of_ri = values_of(*ri, "steady_" + what);
    if (of_rd.empty() || of_ri.empty()) continue;
    const Statistics a = statistics_of(of_rd), b = statistics_of(of_ri);
    metrics[what + "_excess"] = (a.mean - b.mean) / std::hypot(a.standard_error, b.standard_error);
    metrics[what + "_ratio"] = a.mean / b.mean;
  }
}

}  // namespace flowslide
