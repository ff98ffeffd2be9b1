// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <cmath>
#include <string>

#include "grains/require.hpp"

namespace flowslide {

/// Throws std::invalid_argument unless `allowed`: what of the slope is wrong, its value, what is allowed, the mend.
inline void require_of_slope(bool allowed, const std::string& name, double value, const std::string& range,
                             const std::string& mend) {
  require(allowed, "slope: " + name, value, range, mend);
}

/// The same for what must be finite and above zero.
inline void require_positive(const std::string& name, double value, const std::string& unit, const std::string& mend) {
  require_of_slope(std::isfinite(value) && value > 0.0, name, value, "finite and > 0 " + unit, mend);
}

}  // namespace flowslide
