// SPDX-License-Identifier: GPL-2.0-or-later
// Finds the key for a symbol of the paper or of the field, such as "k", "e_0", "mu" or "A".
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace flowslide {

/// The last parts of the keys that `symbol` may mean, the most likely first: "k" gives "hydraulic_conductivity".
/// Underscores are ignored; upper and lower case differ. Empty if the symbol is not known.
std::vector<std::string> keys_of_symbol(std::string_view symbol);

/// The key in `keys` that `key` means if its last part is a symbol: "slope.k" gives "slope.hydraulic_conductivity". Of
/// several such keys, the one whose table has the nearest name. Empty if there is none.
std::string key_meant(std::string_view key, const std::vector<std::string>& keys);

}  // namespace flowslide
