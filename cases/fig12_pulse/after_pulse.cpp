// SPDX-License-Identifier: GPL-2.0-or-later
#include "after_pulse.hpp"

#include <limits>

#include "program/runout.hpp"

namespace flowslide {
namespace {

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

}  // namespace

std::vector<Metric> after_pulse(const SlideOutcome& outcome) {
  const SlideSettings& settings = outcome.point.settings;
  const Series& over_time = outcome.measures.over_time;
  const auto* pulse = std::get_if<SinePulse>(&settings.loading);
  const double after = pulse != nullptr ? pulse->duration : undefined;
  const double end = end_of(over_time), middle = end - 0.5 * velocity_window;  // centre of the last window
  const double first = velocity_at(over_time, after), last = velocity_at(over_time, middle);
  const double free = initial_shear_stress(settings.slope) / mass_per_area(settings.slope);
  const double share = middle > after ? (last - first) / (middle - after) / free : undefined;
  const auto mean_after = [&](const char* column) {
    return pulse != nullptr ? mean_over(over_time, column, after, end) : undefined;
  };
  return {{"final_velocity", last, "m/s", "sliding velocity at the end, as a mean over 0.1 s"},
          {"acceleration_share", share, "1", "mean acceleration after the pulse over tau_d/m"},
          {"liquefied_shear_stress", mean_after("shear_stress"), "Pa", "mean shear stress after the pulse"},
          {"liquefied_normal_stress", mean_after("normal_stress"), "Pa", "mean normal stress after the pulse"}};
}

}  // namespace flowslide
