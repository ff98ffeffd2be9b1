// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <type_traits>

#include "grains/fields.hpp"

namespace flowslide {

/// The next value of a field: the smallest change that there is.
inline void perturb(double& value) { value = std::nextafter(value, HUGE_VAL); }
inline void perturb(bool& value) { value = !value; }
template <typename T>
requires(std::is_integral_v<T> && !std::is_same_v<T, bool>) void perturb(T& value) { ++value; }
template <typename T>
requires std::is_enum_v<T>
void perturb(T& value) { value = static_cast<T>(static_cast<int>(value) + 1); }

/// Calls `visit(name, field, changed)` for each leaf of `owner` and each element of it: a copy with this one perturbed.
template <HasFields Owner, typename Visit>
void for_each_perturbation(const Owner& owner, Visit&& visit) {
  for_each_leaf(owner, [&]<typename F, typename Value>(const std::string& name, const F& field, const Value&) {
    const auto change = [&](auto&& alter) {
      Owner changed = owner;
      for_each_leaf(changed, [&]<typename OtherValue>(const std::string& other, const auto&, OtherValue& value) {
        if constexpr (std::is_same_v<OtherValue, std::remove_const_t<Value>>)
          if (other == name) alter(value);
      });
      visit(name, field, changed);
    };
    if constexpr (requires(std::remove_const_t<Value> & values) { values.size(); }) {
      for (std::size_t i = 0; i < std::tuple_size_v<std::remove_const_t<Value>>; ++i)
        change([&](auto& values) { perturb(values[i]); });
    } else {
      change([](auto& value) { perturb(value); });
    }
  });
}

}  // namespace flowslide
