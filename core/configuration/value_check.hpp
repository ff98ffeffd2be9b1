// SPDX-License-Identifier: GPL-2.0-or-later
// Checks one value of a configuration for type, dimension and range.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "configuration/entry.hpp"
#include "configuration/quantity.hpp"
#include "configuration/range.hpp"

namespace flowslide {

/// Each function returns the value of `scalar`, the value at `key`; quantities in SI units. It throws
/// ConfigurationError if the value is not allowed. The message gives place, key, the value as written, the allowed
/// values and the remedy.
double checked_quantity(std::string_view key, const Scalar& scalar, const Dimension& dimension, const Range& range);
std::int64_t checked_integer(std::string_view key, const Scalar& scalar, const Range& range);
std::string checked_text(std::string_view key, const Scalar& scalar, const std::vector<std::string>& allowed);
bool checked_flag(std::string_view key, const Scalar& scalar);

/// The required quantity in words: "a stress, above 0 Pa".
std::string wanted_quantity(const Dimension& dimension, const Range& range);

/// Throws ConfigurationError. The message gives place and "key = value" as written, then `problem` and `remedy`.
/// Leave `remedy` empty if `problem` includes it.
[[noreturn]] void refuse_value(std::string_view key, const Scalar& scalar, std::string_view problem,
                               std::string_view remedy = {});

}  // namespace flowslide
