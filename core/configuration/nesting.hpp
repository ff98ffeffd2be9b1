// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace flowslide {

/// Largest number of parts of a key ("point.mine.coupling" has three), and of brackets inside one another. The limit
/// protects the stack: the TOML library and Flattener recurse once for each part and bracket.
inline constexpr int most_nesting = 32;

/// The byte offset at which a TOML text exceeds `most_nesting`; empty if it does not. The search ends at a string that
/// is not closed. Does not recurse.
std::optional<std::size_t> too_deep_at(std::string_view toml);

}  // namespace flowslide
