// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "grains/assembly.hpp"

namespace flowslide {

/// All that changes in a sample while it is strained: one of the same properties that takes it goes on bit for bit.
struct SampleState {
  std::map<std::string, double> numbers;  ///< by name, SI; counts are exact up to 2^53
  std::optional<Assembly> grains;         ///< of a sample that is made of them

  /// Throws std::invalid_argument if the state has no such number: it is that of another kind of sample.
  double number(const std::string& name) const;
  /// The same for a count. Throws std::invalid_argument if it is none.
  std::int64_t count(const std::string& name) const;
};

}  // namespace flowslide
