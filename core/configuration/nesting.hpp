// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace flowslide {

/// The parts that a key may have, "point.mine.coupling" has three, and the brackets that may stand within each other.
/// The TOML library and the reader of its tree recurse once for each.
inline constexpr int most_nesting = 32;

/// The offset in a TOML text where it is nested deeper than `most_nesting`; nothing when it is not, or when the text
/// ends before in a string that is not closed. Does not recurse.
std::optional<std::size_t> too_deep_at(std::string_view toml);

}  // namespace flowslide
