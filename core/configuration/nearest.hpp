// SPDX-License-Identifier: GPL-2.0-or-later
// "Did you mean ...?": shared by unknown keys, options, units, engines and points.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace flowslide {

/// The least number of letters to insert, delete, replace or swap with their neighbour to turn `a` into `b`; a change
/// of case counts as none.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The candidate nearest to `text`, the first of equals; empty when none is like it: begins with it, or differs in no
/// more than half of its letters.
std::string nearest(std::string_view text, const std::vector<std::string>& candidates);

/// `did you mean "density"?` of the nearest candidate, or `otherwise`.
std::string did_you_mean(std::string_view text, const std::vector<std::string>& candidates, std::string otherwise);

/// `"a", "b" or "c"`: what is allowed, for a message; "none" when the list is empty.
std::string list_of(const std::vector<std::string>& names);

}  // namespace flowslide
