// SPDX-License-Identifier: GPL-2.0-or-later
// The canonical form of each value in TOML. Equal configurations have equal texts and equal hashes.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace flowslide {

/// The shortest decimal text that reads back as the same double, with a point or an exponent: "28340.0", "5e-07".
std::string canonical(double value);
std::string canonical(std::int64_t value);
std::string canonical(bool value);
/// The text in double quotes, with the escapes of TOML.
std::string canonical(std::string_view text);
std::string canonical(const char* text) = delete;

}  // namespace flowslide
