// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <cmath>
#include <string>

#include "grains/require.hpp"

namespace flowslide {

/// Throws std::invalid_argument unless `allowed`. The message names the property of the slope, its value, the allowed
/// range and the remedy.
inline void require_of_slope(bool allowed, const std::string& name, double value, const std::string& range,
                             const std::string& remedy) {
  require(allowed, "slope: " + name, value, range, remedy);
}

/// The same for a value that must be finite and > 0.
inline void require_positive(const std::string& name, double value, const std::string& unit,
                             const std::string& remedy) {
  require_of_slope(std::isfinite(value) && value > 0.0, name, value, "finite and > 0 " + unit, remedy);
}

}  // namespace flowslide
