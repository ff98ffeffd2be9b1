// SPDX-License-Identifier: GPL-2.0-or-later
#include "profile_metrics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiment/profile_record.hpp"

namespace flowslide {
namespace {

constexpr std::size_t near_a_plane = 3;  ///< number of sublayers in "top" and in "bottom"

double mean(const std::vector<double>& values, std::size_t from, std::size_t to) {
  double sum = 0.0;
  for (std::size_t i = from; i < to; ++i) sum += values[i];
  return sum / static_cast<double>(to - from);
}

double unevenness(const std::vector<double>& values, std::size_t from, std::size_t to) {
  const double middle = mean(values, from, to);
  double largest = 0.0;
  for (std::size_t i = from; i < to; ++i) largest = std::max(largest, std::abs(values[i] - middle));
  return largest / std::abs(middle);
}

}  // namespace

std::vector<Metric> profile_metrics(const Series& profiles) {
  std::vector<Metric> metrics;
  const std::size_t layers = profiles.rows();
  if (layers <= 2 * near_a_plane) return metrics;
  for (std::size_t i = 1; profiles.has(fmt::format("velocity_{}", i)); ++i)
    for (const std::string of : {"", "snapshot_", "mean_"}) {
      if (!profiles.has(fmt::format("{}velocity_{}", of, i))) continue;
      const auto name = [&](const char* what) { return fmt::format("{}{}_{}", of, what, i); };
      const std::vector<double>& shear = profiles.column(name("shear_stress")).values;
      const std::vector<double>& normal = profiles.column(name("normal_stress")).values;
      metrics.push_back({name("linearity"), linearity(profiles, name("velocity")), "1",
                         "R^2 of a straight line through the velocity profile"});
      metrics.push_back({name("shear_top"), mean(shear, layers - 1 - near_a_plane, layers - 1), "1",
                         "shear stress of upper sublayers over that of the sample"});
      metrics.push_back({name("shear_bottom"), mean(shear, 1, 1 + near_a_plane), "1",
                         "shear stress of lower sublayers over that of the sample"});
      metrics.push_back({name("normal_unevenness"), unevenness(normal, 1, layers - 1), "1",
                         "largest difference of a sublayer's normal stress from their mean, over the mean"});
    }
  return metrics;
}

}  // namespace flowslide
