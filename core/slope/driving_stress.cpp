// SPDX-License-Identifier: GPL-2.0-or-later
#include "slope/driving_stress.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "slope/require.hpp"

namespace flowslide {
namespace {

void require_finite(const std::string& name, double value, const std::string& unit) {
  require_of_slope(std::isfinite(value), name, value, "any finite value in " + unit, "Give a number.");
}

void check(const NoChange&) {}

void check(const ConstantRate& loading) {
  require_finite("rate of the driving stress", loading.rate, "Pa/s");
  require_of_slope(loading.duration > 0.0, "duration of the loading", loading.duration, "> 0 s",
                   "Leave it out to load without end.");
}

void check(const SinePulse& pulse) {
  require_finite("amplitude of the pulse", pulse.amplitude, "Pa");
  require_positive("duration of the pulse", pulse.duration, "s", "Give T, such as 2 s.");
}

void check(const StressTable& table) {
  const auto rows = static_cast<double>(table.time.size());
  require_of_slope(!table.time.empty(), "number of rows of the loading table", rows, "1 or more",
                   "Give times in s and changes of the shear stress in Pa.");
  require_of_slope(table.time.size() == table.change.size(), "number of stresses of the loading table",
                   static_cast<double>(table.change.size()), fmt::format("{}", table.time.size()),
                   "Give one stress per time.");
  for (std::size_t row = 0; row < table.time.size(); ++row) {
    const std::string of_row = fmt::format(" in row {} of the loading table", row + 1);
    require_finite("time" + of_row, table.time[row], "s");
    require_finite("stress" + of_row, table.change[row], "Pa");
    require_of_slope(row == 0 || table.time[row] > table.time[row - 1], "time" + of_row, table.time[row],
                     "more than the time before it", "Sort the rows by time and leave no time twice.");
  }
}

double change_at(const NoChange&, double) { return 0.0; }

double change_at(const ConstantRate& loading, double time) { return loading.rate * std::min(time, loading.duration); }

double change_at(const SinePulse& pulse, double time) {
  return time < pulse.duration ? pulse.amplitude * std::sin(std::numbers::pi * time / pulse.duration) : 0.0;
}

double change_at(const StressTable& table, double time) {
  const auto above = std::upper_bound(table.time.begin(), table.time.end(), time);
  if (above == table.time.begin()) return table.change.front();
  if (above == table.time.end()) return table.change.back();
  const auto row = static_cast<std::size_t>(above - table.time.begin());
  const double share = (time - table.time[row - 1]) / (table.time[row] - table.time[row - 1]);
  return std::lerp(table.change[row - 1], table.change[row], share);
}

}  // namespace

void validate(const StressHistory& history) {
  std::visit([](const auto& kind) { check(kind); }, history);
}

double stress_change(const StressHistory& history, double time) {
  return std::visit([time](const auto& kind) { return change_at(kind, time); }, history);
}

DrivingStress::DrivingStress(const SlopeProperties& slope, StressHistory history)
    : history_(std::move(history)), initial_(initial_shear_stress(slope)) {
  validate(history_);
}

}  // namespace flowslide
