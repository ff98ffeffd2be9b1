// SPDX-License-Identifier: GPL-2.0-or-later
// Keys of a configuration by the symbols that the paper, and the field, write for them: "k", "e_0", "mu", "A".
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace flowslide {

/// The last parts of the keys that `symbol` may stand for, the likeliest first: "k" gives "hydraulic_conductivity".
/// Underscores do not count, upper and lower case do. Empty when it is no symbol.
std::vector<std::string> keys_of_symbol(std::string_view symbol);

/// The one of `keys` that `key` means when its last part is a symbol: "slope.k" gives "slope.hydraulic_conductivity".
/// Of several that in the table whose name is nearest. Empty when there is none.
std::string key_meant(std::string_view key, const std::vector<std::string>& keys);

}  // namespace flowslide
