// SPDX-License-Identifier: GPL-2.0-or-later
#include "sample/sample_state.hpp"

#include <cmath>
#include <stdexcept>

namespace flowslide {

double SampleState::number(const std::string& name) const {
  const auto found = numbers.find(name);
  if (found == numbers.end())
    throw std::invalid_argument("the state of a sample has no " + name + ": it is that of another kind of sample");
  return found->second;
}

std::int64_t SampleState::count(const std::string& name) const {
  constexpr double largest = 9007199254740992.0;  // 2^53
  const double value = number(name);
  if (!(value >= 0.0 && value <= largest && value == std::floor(value)))
    throw std::invalid_argument("the state of a sample has no count in " + name);
  return static_cast<std::int64_t>(value);
}

}  // namespace flowslide
