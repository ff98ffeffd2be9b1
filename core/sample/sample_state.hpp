// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "grains/assembly.hpp"

namespace flowslide {

/// All variables of a sample that change while it is strained. A sample of the same properties that restores this state
/// continues bit for bit.
struct SampleState {
  std::map<std::string, double> numbers;  ///< by name, in SI units; counts are exact up to 2^53
  std::optional<Assembly> grains;         ///< empty for a closed-form sample

  /// Throws std::invalid_argument if the state has no such number, and thus belongs to another kind of sample.
  double number(const std::string& name) const;
  /// The same for a count. Throws std::invalid_argument also if the number is not a whole number from 0 to 2^53.
  std::int64_t count(const std::string& name) const;
};

}  // namespace flowslide
