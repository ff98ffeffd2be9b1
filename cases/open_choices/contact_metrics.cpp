// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact_metrics.hpp"

#include <algorithm>
#include <cmath>

#include "grains/contact_search.hpp"
#include "sample/stable_time_step.hpp"

namespace flowslide {

std::vector<Metric> contact_metrics(const Assembly& grains, const Material& material, double time_step) {
  std::vector<double> overlaps, free;
  for (const auto& [i, j] : touching_pairs(grains)) {
    const double distance = grains.cell.nearest_image(grains.position[i] - grains.position[j]).norm();
    const double overlap = grains.radius[i] + grains.radius[j] - distance;
    overlaps.push_back(overlap);
    if (grains.role[i] == Role::mobile && grains.role[j] == Role::mobile) free.push_back(overlap);
  }
  std::vector<Metric> metrics;
  const auto add = [&](const char* name, double value, const char* unit, const char* text) {
    if (std::isfinite(value)) metrics.push_back({name, value, unit, text});
  };
  if (!overlaps.empty()) {
    std::sort(overlaps.begin(), overlaps.end());
    add("median_overlap", overlaps[overlaps.size() / 2], "m", "median overlap of the contacts at the end");
    add("largest_overlap", overlaps.back(), "m", "largest overlap at the end");
  }
  if (!free.empty())
    add("largest_free_overlap", *std::max_element(free.begin(), free.end()), "m",
        "largest overlap of two mobile grains at the end");
  add("stable_time_step", stable_time_step(grains, material, time_step), "s", "0.8 of a stable time step at the end");
  return metrics;
}

}  // namespace flowslide
