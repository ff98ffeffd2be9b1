// SPDX-License-Identifier: GPL-2.0-or-later
#include "trigger_metrics.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "app/ensemble.hpp"

namespace flowslide {
namespace {

constexpr double peak_before = 0.05;  ///< strain within which the sample has its peak
constexpr int friction_windows = 60;

}  // namespace

std::size_t peak_row(const Series& series) {
  const auto &strain = series.column("shear_strain").values, &stress = series.column("shear_stress").values;
  std::size_t peak = 0;
  for (std::size_t row = 0; row < series.rows() && strain[row] <= peak_before; ++row)
    if (stress[row] > stress[peak]) peak = row;
  return peak;
}

Series friction(const Series& series) {
  Series result;
  result.axis = {"shear_strain", "gamma", "1", "shear strain of the liquefiable layer", "positive downslope", {}};
  result.columns = {{"friction", "mu", "1", "shear over normal stress", "", {}}};
  const double width = friction_until / friction_windows;
  for (int window = 0; window < friction_windows; ++window) {
    const double from = window * width, to = from + width;
    const double value = mean_between(series, "shear_stress", "shear_strain", from, to) /
                         mean_between(series, "normal_stress", "shear_strain", from, to);
    if (!std::isfinite(value)) break;
    result.append_row(0.5 * (from + to), std::array{value});
  }
  return result;
}

std::vector<Metric> trigger_metrics(const Series& series) {
  const auto column = [&](const char* name) -> const std::vector<double>& { return series.column(name).values; };
  const auto steady = [&](const char* name) {
    return mean_between(series, name, "shear_strain", steady_from, std::numeric_limits<double>::infinity());
  };
  const std::size_t peak = peak_row(series);
  double number = 0.0, lowest = std::numeric_limits<double>::infinity();
  for (std::size_t row = 0; row < series.rows(); ++row) {
    if (row <= peak) number = std::max(number, column("global_inertial_number")[row]);
    if (column("shear_strain")[row] <= steady_from) lowest = std::min(lowest, column("normal_stress")[row]);
  }
  const double shear = steady("shear_stress"), normal = steady("normal_stress");
  return {{"peak_shear_stress", column("shear_stress")[peak], "Pa", "largest shear stress up to 5 % strain"},
          {"strain_at_peak", column("shear_strain")[peak], "1", "shear strain at that stress"},
          {"largest_inertial_number_before_peak", number, "1", "largest inertial number of the slope until then"},
          {"lowest_normal_stress", lowest, "Pa", "lowest normal stress up to 50 % strain"},
          {"steady_shear", shear, "Pa", "mean shear stress beyond 50 % strain"},
          {"steady_normal", normal, "Pa", "mean normal stress beyond 50 % strain"},
          {"steady_friction", shear / normal, "1", "mu_ss, the former over the latter"},
          {"steady_inertial_number", steady("global_inertial_number"), "1",
           "mean inertial number of the slope's rate beyond 50 % strain"},
          {"steady_applied_inertial_number", steady("inertial_number"), "1",
           "mean inertial number of the rate applied beyond 50 % strain"},
          {"final_velocity", column("velocity").back(), "m/s", "sliding velocity at the end"}};
}

}  // namespace flowslide
