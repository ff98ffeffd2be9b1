// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <string>
#include <string_view>

namespace flowslide {

/// Differences of two texts of lines "key = value", for a message: "size = 0.002 there, 0.003 now; count = 2 is only
/// there". `there` is the text of the existing file, `now` that of the present run. Sorted by key; lists at most `most`
/// keys and the number of further ones. Empty if there is no difference.
std::string difference_of(std::string_view there, std::string_view now, int most = 5);

}  // namespace flowslide
