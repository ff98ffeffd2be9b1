// SPDX-License-Identifier: GPL-2.0-or-later
// One scalar of a configuration, checked for type, dimension and range.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "configuration/entry.hpp"
#include "configuration/quantity.hpp"
#include "configuration/range.hpp"

namespace flowslide {

/// Each returns the value of `scalar`, which stands at `key`, or throws ConfigurationError: place, key, the value as
/// written, what is allowed, and how to mend it.
double checked_quantity(std::string_view key, const Scalar& scalar, const Dimension& dimension, const Range& range);
std::int64_t checked_integer(std::string_view key, const Scalar& scalar, const Range& range);
std::string checked_text(std::string_view key, const Scalar& scalar, const std::vector<std::string>& allowed);
bool checked_flag(std::string_view key, const Scalar& scalar);

/// "a stress above 0 Pa": what is wanted, in words.
std::string wanted_quantity(const Dimension& dimension, const Range& range);

/// Throws ConfigurationError: place, key = value as written, then the problem and the mend, if `problem` does not hold
/// it.
[[noreturn]] void refuse_value(std::string_view key, const Scalar& scalar, std::string_view problem,
                               std::string_view mend = {});

}  // namespace flowslide
