// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <string>
#include <string_view>

namespace flowslide {

/// XXH3 of 128 bits, as 32 lower-case hexadecimal digits: the one hash of this project, for configurations, recipes and
/// files. It finds damage and change, not forgery. The command `xxhsum -H128` gives the same.
std::string hash_of(std::string_view bytes);

}  // namespace flowslide
