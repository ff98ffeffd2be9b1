// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <fmt/format.h>

#include <stdexcept>
#include <string>

namespace flowslide {

/// Throws std::invalid_argument unless `allowed`. The message gives the name, its value, the allowed range and the
/// remedy.
inline void require(bool allowed, const std::string& name, double value, const std::string& range,
                    const std::string& remedy) {
  if (allowed) return;
  throw std::invalid_argument(fmt::format("{} is {}; allowed: {}. {}", name, value, range, remedy));
}

}  // namespace flowslide
