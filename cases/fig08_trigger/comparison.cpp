// SPDX-License-Identifier: GPL-2.0-or-later
#include "comparison.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "trigger_metrics.hpp"

namespace flowslide {
namespace {

constexpr int path_windows = 20;  ///< windows of strain up to the peak; stresses are means over them
constexpr double last_part = 0.9;  ///< velocities are compared from this fraction of the displacement on

struct Schemes {
  const Ensemble* rd = nullptr;
  const Ensemble* ri = nullptr;
};

Schemes schemes_of(const Ensembles& slides, const std::string& loading) {
  const auto rd = slides.find("RD_" + loading), ri = slides.find("RI_" + loading);
  if (rd == slides.end() || ri == slides.end()) return {};
  return {&rd->second, &ri->second};
}

/// RMS difference between RD and RI on the same sample / RMS standard deviation of RI between samples. Each row has the
/// pairs (RD, RI) of all samples for one quantity, such as tau in one window of strain.
double difference_over_spread(const std::vector<std::vector<std::pair<double, double>>>& rows) {
  double differences = 0.0, variances = 0.0;
  for (const auto& row : rows) {
    std::vector<double> of_ri;
    for (const auto& [rd, ri] : row) {
      differences += (rd - ri) * (rd - ri) / static_cast<double>(row.size());
      of_ri.push_back(ri);
    }
    const double deviation = statistics_of(of_ri).deviation;
    variances += deviation * deviation;
  }
  return std::sqrt(differences / variances);
}

std::vector<std::vector<std::pair<double, double>>> windows(const std::vector<Pair>& pairs, const std::string& column,
                                                            double end) {
  std::vector<std::vector<std::pair<double, double>>> rows;
  for (int window = 0; window < path_windows; ++window) {
    const auto mean = [&](const Result& result) {
      return mean_over(windows_over(result, "shear_strain"), column, end * window / path_windows,
                       end * (window + 1) / path_windows);
    };
    rows.emplace_back();
    for (const auto& [rd, ri] : pairs) rows.back().emplace_back(mean(*rd), mean(*ri));
  }
  return rows;
}

double earliest_peak(const std::vector<Pair>& pairs) {
  double earliest = std::numeric_limits<double>::infinity();
  for (const auto& [rd, ri] : paired_values(pairs, "strain_at_peak")) earliest = std::min({earliest, rd, ri});
  return earliest;
}

/// Mean velocity of RD / mean velocity of RI over the last tenth of the displacement that both reach.
double velocity_ratio(const Series& rd, const Series& ri) {
  const double end = std::min(end_of(rd), end_of(ri));
  return mean_over(rd, "velocity", last_part * end, end) / mean_over(ri, "velocity", last_part * end, end);
}

}  // namespace

void compare_ramps(const Ensembles& slides, std::map<std::string, double>& metrics) {
  const auto [rd, ri] = schemes_of(slides, "ramp");
  if (rd == nullptr) return;
  const std::vector<Pair> pairs = paired(*rd, *ri);
  if (pairs.size() < 2) return;
  const double end = earliest_peak(pairs);
  double path = 0.0;
  for (const char* column : {"shear_stress", "normal_stress"})
    path = std::max(path, difference_over_spread(windows(pairs, column, end)));
  metrics["path_difference_over_spread"] = path;
  metrics["peak_difference_over_spread"] = difference_over_spread({paired_values(pairs, "peak_shear_stress")});
  std::vector<double> ratios;
  for (const auto& [a, b] : pairs)
    ratios.push_back(velocity_ratio(windows_over(*a, "displacement"), windows_over(*b, "displacement")));
  metrics["velocity_ratio"] = statistics_of(ratios).median;
  metrics["inertial_number_ratio"] = paired_ratio(*ri, *rd, "steady_inertial_number").median;
}

void compare_steady_states(const Ensembles& slides, std::map<std::string, double>& metrics) {
  const auto [rd, ri] = schemes_of(slides, "hold");
  if (rd == nullptr) return;
  for (const std::string what : {"shear", "normal", "friction"}) {
    const Statistics excess = paired_difference(*rd, *ri, "steady_" + what);
    if (std::isnan(excess.mean)) continue;
    metrics[what + "_ratio"] = paired_ratio(*rd, *ri, "steady_" + what).median;
    if (excess.standard_error > 0.0) metrics[what + "_excess"] = excess.mean / excess.standard_error;
  }
}

}  // namespace flowslide
