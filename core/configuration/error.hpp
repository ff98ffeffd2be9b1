// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <stdexcept>
#include <string>
#include <utility>

namespace flowslide {

/// The user asked for something that is not possible. The message says what was given, what is allowed, and how to
/// correct it.
class ConfigurationError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Calls `read` and returns its result. Replaces std::invalid_argument by ConfigurationError, because the invalid value
/// comes from the user. The message then begins with `place`.
template <typename Read>
auto as_written_by_user(const std::string& place, Read&& read) {
  try {
    return std::forward<Read>(read)();
  } catch (const std::invalid_argument& error) {
    throw ConfigurationError((place.empty() ? "" : place + ": ") + error.what());
  }
}

}  // namespace flowslide
