// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <limits>
#include <string>

#include "configuration/quantity.hpp"

namespace flowslide {

/// The range of allowed values of a key, in SI units. No range contains infinity or NaN.
struct Range {
  double lowest = -std::numeric_limits<double>::infinity();
  double highest = std::numeric_limits<double>::infinity();
  bool lowest_allowed = true;   ///< false: the lowest value itself is excluded
  bool highest_allowed = true;  ///< false: the highest value itself is excluded

  static Range any() { return {}; }
  static Range positive() { return above(0.0); }
  static Range not_negative() { return at_least(0.0); }
  static Range at_least(double low) { return {.lowest = low}; }
  static Range at_most(double high) { return {.highest = high}; }
  static Range above(double low) { return {.lowest = low, .lowest_allowed = false}; }
  static Range below(double high) { return {.highest = high, .highest_allowed = false}; }
  /// [low, high]
  static Range between(double low, double high) { return {.lowest = low, .highest = high}; }
  /// (low, high)
  static Range inside(double low, double high) { return {low, high, false, false}; }
  /// (low, high]
  static Range above_up_to(double low, double high) { return {low, high, false, true}; }
  /// [low, high)
  static Range from_below(double low, double high) { return {low, high, true, false}; }

  /// Whether the value is finite and lies in the range.
  bool contains(double value) const;
  /// The range in words: "above 0 Pa", "between 0 and 1", "at least 3 and below 5", "any finite number". Angles are
  /// given in degrees.
  std::string describe(const Dimension& dimension = dimension::dimensionless) const;
};

}  // namespace flowslide
