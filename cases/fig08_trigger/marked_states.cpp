// SPDX-License-Identifier: GPL-2.0-or-later
#include "marked_states.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "record/gnuplot_table.hpp"

namespace flowslide {
namespace {

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

/// Number of the row whose time is next to `time` (s). The series has rows.
std::size_t row_at(const Series& series, double time) {
  const std::vector<double>& times = series.axis.values;
  const auto next = std::min_element(times.begin(), times.end(), [&](double a, double b) {
    return std::abs(a - time) < std::abs(b - time);
  });
  return static_cast<std::size_t>(next - times.begin());
}

}  // namespace

std::optional<std::size_t> liquefied_row(const Series& series) {
  const std::vector<double>& normal = series.column("normal_stress").values;
  const auto found = std::find_if(normal.begin(), normal.end(),
                                  [&](double value) { return value < liquefied_share * normal.front(); });
  if (found == normal.end()) return std::nullopt;
  return static_cast<std::size_t>(found - normal.begin());
}

double liquefaction_strain(const Series& series) {
  const auto row = liquefied_row(series);
  return row ? series.column("shear_strain").values[*row] : undefined;
}

std::string marked_states_head() {
  const std::string downslope = "positive downslope", compression = "compression positive";
  return table_head(
      {{"slide", "", "text", "name of the slide", "", {}},
       {"time", "t", "s", "time at the peak of the shear stress", "", {}},
       {"shear_stress", "tau", "Pa", "shear stress at the peak", downslope, {}},
       {"normal_stress", "sigma", "Pa", "normal stress at the peak", compression, {}},
       {"velocity", "v", "m/s", "sliding velocity at the peak", downslope, {}},
       {"global_inertial_number", "I", "1", "inertial number of the rate of the slope at the peak", "", {}},
       {"liquefied_time", "t", "s", "time when sigma first falls below 1 % of its initial value", "", {}},
       {"liquefied_shear_stress", "tau", "Pa", "shear stress at that time", downslope, {}},
       {"liquefied_normal_stress", "sigma", "Pa", "normal stress at that time", compression, {}},
       {"liquefied_velocity", "v", "m/s", "sliding velocity at that time", downslope, {}},
       {"liquefied_global_inertial_number",
        "I",
        "1",
        "inertial number of the rate of the slope at that time",
        "",
        {}}});
}

std::string marked_states_row(const std::string& slide, const Result& result) {
  const Series& series = result.series;
  const double time = metric_of(result, "time_at_peak"), shear = metric_of(result, "peak_shear_stress");
  const double normal = metric_of(result, "normal_stress_at_peak");
  if (!std::isfinite(time + shear + normal) || series.rows() == 0) return "";
  const std::size_t peak = row_at(series, time);
  std::string row = fmt::format("{} {} {} {} {} {}", slide, time, shear, normal, series.column("velocity").values[peak],
                                series.column("global_inertial_number").values[peak]);
  const auto liquefied = liquefied_row(series);
  for (const char* name : {"time", "shear_stress", "normal_stress", "velocity", "global_inertial_number"})
    row += fmt::format(" {}", liquefied ? series.column(name).values[*liquefied] : undefined);
  return row + "\n";
}

}  // namespace flowslide
