// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <string>
#include <string_view>

namespace flowslide {

/// SHA-256 (FIPS 180-4) of any bytes, as 64 lower-case hexadecimal digits; the same as the command sha256sum.
std::string sha256(std::string_view bytes);

}  // namespace flowslide
