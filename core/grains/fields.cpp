// SPDX-License-Identifier: GPL-2.0-or-later
#include "grains/fields.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <stdexcept>

namespace flowslide {

bool Bounds::contain(double value) const {
  return std::isfinite(value) && (lowest_allowed ? value >= lowest : value > lowest) &&
         (highest_allowed ? value <= highest : value < highest);
}

std::string Bounds::describe() const {
  const bool has_lowest = std::isfinite(lowest), has_highest = std::isfinite(highest);
  if (!has_lowest && !has_highest) return "any finite number";
  std::string text;
  if (has_lowest) text = (lowest_allowed ? "at least " : "above ") + field_text(lowest);
  if (has_lowest && has_highest) text += " and ";
  if (has_highest) text += (highest_allowed ? "at most " : "below ") + field_text(highest);
  return text;
}

std::string field_text(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

std::string field_text(std::int64_t value) { return fmt::to_string(value); }

std::string field_text(std::uint64_t value) { return fmt::to_string(value); }

std::string field_text(bool value) { return value ? "true" : "false"; }

void require_within(const Bounds& bounds, const std::string& name, double value, const std::string& unit) {
  if (bounds.contain(value)) return;
  const std::string suffix = unit == "1" ? "" : " " + unit;
  throw std::invalid_argument(name + " = " + field_text(value) + suffix + " is not allowed: it must be " +
                              bounds.describe() + suffix + "; change it");
}

}  // namespace flowslide
