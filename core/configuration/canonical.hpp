// SPDX-License-Identifier: GPL-2.0-or-later
// One way, and one only, to write each value as TOML, so that equal configurations have equal texts and hashes.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace flowslide {

/// The shortest form that gives the same double again, always with a point or an exponent: "28340.0", "5e-07".
std::string canonical(double value);
std::string canonical(std::int64_t value);
std::string canonical(bool value);
/// In double quotes, with TOML's escapes.
std::string canonical(std::string_view text);
std::string canonical(const char* text) = delete;

}  // namespace flowslide
