// SPDX-License-Identifier: GPL-2.0-or-later
#include "runout_metrics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "app/ensemble.hpp"

namespace flowslide {
namespace {

constexpr double peak_before = 0.02;  ///< strain within which the sample has its peak
constexpr double window = 0.1;        ///< s, over which velocities are means: grains make them swing

double largest_stress(const Series& series) {
  const auto &strain = series.column("shear_strain").values, &stress = series.column("shear_stress").values;
  double largest = stress.front();
  for (std::size_t row = 0; row < series.rows() && strain[row] <= peak_before; ++row)
    largest = std::max(largest, stress[row]);
  return largest;
}

}  // namespace

double velocity_at(const Series& series, double time) {
  if (series.axis.values.back() < time + 0.5 * window) return std::numeric_limits<double>::quiet_NaN();
  return mean_between(series, "velocity", "time", time - 0.5 * window, time + 0.5 * window);
}

std::vector<Metric> runout_metrics(const Series& series, const SlideSettings& settings) {
  const auto* pulse = std::get_if<SinePulse>(&settings.loading);
  if (pulse == nullptr) throw std::invalid_argument("the loading of a runout must be a pulse: set its history so");
  const double end = series.axis.values.back() - 0.5 * window, after = pulse->duration;
  double largest = 0.0;
  for (double time = 0.5 * window; time < end; time += 0.5 * window)
    largest = std::max(largest, velocity_at(series, time));
  const double first = velocity_at(series, after), last = velocity_at(series, end);
  const double free = initial_shear_stress(settings.slope) / mass_per_area(settings.slope);
  const double share = end > after ? (last - first) / (end - after) / free : std::numeric_limits<double>::quiet_NaN();
  const auto mean_after = [&](const char* column) {
    return mean_between(series, column, "time", after, end + 0.5 * window);
  };
  return {{"peak_shear_stress", largest_stress(series), "Pa", "largest shear stress up to 2 % strain"},
          {"largest_velocity", largest, "m/s", "largest sliding velocity, as a mean over 0.1 s"},
          {"velocity_after_pulse", first, "m/s", "sliding velocity when the pulse ends"},
          {"final_velocity", last, "m/s", "sliding velocity at the end, as a mean over 0.1 s"},
          {"final_displacement", series.column("displacement").values.back(), "m", "sliding distance at the end"},
          {"acceleration_share", share, "1", "mean acceleration after the pulse over tau_d/m"},
          {"liquefied_shear_stress", mean_after("shear_stress"), "Pa", "mean shear stress after the pulse"},
          {"liquefied_normal_stress", mean_after("normal_stress"), "Pa", "mean normal stress after the pulse"}};
}

}  // namespace flowslide
