// SPDX-License-Identifier: GPL-2.0-or-later
#include "configuration/range.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace flowslide {

bool Range::contains(double value) const {
  if (!std::isfinite(value)) return false;
  const bool high_enough = lowest_allowed ? value >= lowest : value > lowest;
  const bool low_enough = highest_allowed ? value <= highest : value < highest;
  return high_enough && low_enough;
}

std::string Range::describe(const Dimension& dimension) const {
  const std::string unit = unit_of(dimension);
  const auto bound = [&](double value) {
    if (dimension == dimension::angle) return fmt::format("{:.4g} deg", value * 180.0 / std::numbers::pi);
    return unit.empty() ? fmt::format("{}", value) : fmt::format("{} {}", value, unit);
  };
  const bool has_lowest = std::isfinite(lowest);
  const bool has_highest = std::isfinite(highest);
  if (!has_lowest && !has_highest) return "any finite number";
  if (has_lowest && has_highest && lowest_allowed && highest_allowed)
    return fmt::format("between {} and {}", bound(lowest), bound(highest));
  std::string text;
  if (has_lowest) text = (lowest_allowed ? "at least " : "above ") + bound(lowest);
  if (has_lowest && has_highest) text += " and ";
  if (has_highest) text += (highest_allowed ? "at most " : "below ") + bound(highest);
  return text;
}

}  // namespace flowslide
