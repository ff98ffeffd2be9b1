// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <stdexcept>
#include <string>
#include <utility>

namespace flowslide {

/// The user asked for something that cannot be done. The message says what was given, what is allowed and the mend.
class ConfigurationError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Calls `read` and returns its result. What it refuses (std::invalid_argument), the user has written: it throws
/// ConfigurationError instead, with `place` in front of the message.
template <typename Read>
auto as_written_by_user(const std::string& place, Read&& read) {
  try {
    return std::forward<Read>(read)();
  } catch (const std::invalid_argument& error) {
    throw ConfigurationError((place.empty() ? "" : place + ": ") + error.what());
  }
}

}  // namespace flowslide
