// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <string>
#include <string_view>

namespace flowslide {

/// How two resolved configurations differ, for a message: "size = 0.002 there, 0.003 now; count is only there", in the
/// order of the keys, at most `most` of them and how many more. Empty if they do not.
std::string difference_of(std::string_view there, std::string_view now, int most = 5);

}  // namespace flowslide
