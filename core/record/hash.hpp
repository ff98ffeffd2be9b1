// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <string>
#include <string_view>

namespace flowslide {

/// XXH3 hash of 128 bits, as 32 lower-case hexadecimal digits. This project uses it for configurations, recipes and
/// files. It detects damage and change, not forgery. The command `xxhsum -H128` gives the same hash.
std::string hash_of(std::string_view bytes);

}  // namespace flowslide
