// SPDX-License-Identifier: GPL-2.0-or-later
// Enumerations whose values have names in a configuration and in texts.
#pragma once
#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <vector>

namespace flowslide {

/// Specialise this for an enumeration with the enumerators 0, 1, ...: `what`, the words for it in a message, and
/// `names`, an array of texts in the order of the enumerators.
template <typename Enum>
struct ChoiceNames;

template <typename Enum>
concept Choice = requires { ChoiceNames<Enum>::names.size(); };

template <Choice Enum>
std::string name_of(Enum value) {
  return ChoiceNames<Enum>::names.at(static_cast<std::size_t>(value));
}

/// All names.
template <Choice Enum>
std::vector<std::string> choice_names() {
  return {ChoiceNames<Enum>::names.begin(), ChoiceNames<Enum>::names.end()};
}

/// The value with this name. Throws std::invalid_argument for another name; the message gives the allowed names.
template <Choice Enum>
Enum choice_of(const std::string& name) {
  const auto& names = ChoiceNames<Enum>::names;
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<Enum>(found - names.begin());
  std::string allowed;
  for (const char* one : names) allowed += (allowed.empty() ? "\"" : ", \"") + std::string(one) + "\"";
  throw std::invalid_argument(std::string(ChoiceNames<Enum>::what) + " \"" + name + "\" is not known; choose one of: " +
                              allowed);
}

}  // namespace flowslide
