// SPDX-License-Identifier: GPL-2.0-or-later
#include "trigger_metrics.hpp"

#include <array>
#include <cmath>
#include <limits>

namespace flowslide {
namespace {

constexpr int friction_windows = 60;

}  // namespace

Series friction(const Series& over_strain) {
  Series result;
  result.axis = {"shear_strain", "gamma", "1", "shear strain of the liquefiable layer", "positive downslope", {}};
  result.columns = {{"friction", "mu", "1", "shear over normal stress", "", {}}};
  const double width = friction_until / friction_windows;
  for (int window = 0; window < friction_windows; ++window) {
    const double from = window * width, to = from + width;
    const double value =
        mean_over(over_strain, "shear_stress", from, to) / mean_over(over_strain, "normal_stress", from, to);
    if (!std::isfinite(value)) break;
    result.append_row(0.5 * (from + to), std::array{value});
  }
  return result;
}

std::vector<Metric> trigger_metrics(const RunMeasures& measures, double final_velocity) {
  const auto steady = [&](const char* name) {
    return mean_over(measures.over_strain, name, steady_from, std::numeric_limits<double>::infinity());
  };
  const StressPeak& peak = measures.peak_to_5;
  const double shear = steady("shear_stress"), normal = steady("normal_stress");
  return {{"peak_shear_stress", peak.stress, "Pa", "largest shear stress up to 5 % strain"},
          {"strain_at_peak", peak.strain, "1", "shear strain at that stress"},
          {"time_at_peak", peak.time, "s", "time of that stress"},
          {"normal_stress_at_peak", peak.normal, "Pa", "normal stress at that time"},
          {"largest_inertial_number_before_peak", peak.largest_number, "1",
           "largest inertial number of the slope until then"},
          {"lowest_normal_stress", measures.lowest_normal_stress, "Pa", "lowest normal stress up to 50 % strain"},
          {"steady_shear", shear, "Pa", "mean shear stress beyond 50 % strain"},
          {"steady_normal", normal, "Pa", "mean normal stress beyond 50 % strain"},
          {"steady_friction", shear / normal, "1", "mu_ss, steady_shear over steady_normal"},
          {"steady_inertial_number", steady("global_inertial_number"), "1",
           "mean inertial number of the slope's rate beyond 50 % strain"},
          {"steady_applied_inertial_number", steady("inertial_number"), "1",
           "mean inertial number of the rate applied beyond 50 % strain"},
          {"final_velocity", final_velocity, "m/s", "sliding velocity at the end"}};
}

}  // namespace flowslide
