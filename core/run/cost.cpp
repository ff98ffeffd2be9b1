// SPDX-License-Identifier: GPL-2.0-or-later
#include "run/cost.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "process/progress.hpp"

namespace flowslide {

Cost cost_of(std::span<const Provenance> points) {
  Cost cost;
  for (const Provenance& point : points) {
    ++cost.points;
    if (!std::isfinite(point.processor_seconds) || !std::isfinite(point.predicted_seconds)) continue;
    ++cost.recorded;
    cost.predicted_seconds += point.predicted_seconds;
    cost.processor_seconds += point.processor_seconds;
  }
  return cost;
}

std::string cost_text(const Cost& cost) {
  if (cost.recorded == 0) return "cost: not recorded";
  const int unrecorded = cost.points - cost.recorded;
  return fmt::format("cost: {} of processor time, {} predicted{}", duration_text(cost.processor_seconds),
                     prediction_text(cost.predicted_seconds),
                     unrecorded > 0
                         ? fmt::format("; without {} of {} runs, which did not record it", unrecorded, cost.points)
                         : "");
}

std::string cost_json(const Cost& cost) {
  const nlohmann::ordered_json object{{"points", cost.points},
                                      {"recorded", cost.recorded},
                                      {"predicted_seconds", cost.predicted_seconds},
                                      {"processor_seconds", cost.processor_seconds}};
  return object.dump() + "\n";
}

}  // namespace flowslide
