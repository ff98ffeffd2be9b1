// SPDX-License-Identifier: GPL-2.0-or-later
// Proposals such as `did you mean "density"?` for unknown keys, options, units, engines and runs.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace flowslide {

/// The smallest number of edits that turn `a` into `b`. An edit inserts, deletes or replaces a letter, or swaps two
/// neighbours. Upper and lower case count as equal.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The candidate with the smallest edit distance to `text`; of several, the first. It must begin with `text`, or its
/// distance must be at most half of the letters of the longer text (at least 1). Otherwise the result is empty.
std::string nearest(std::string_view text, const std::vector<std::string>& candidates);

/// `did you mean "density"?` with the nearest candidate; `otherwise` if there is none.
std::string did_you_mean(std::string_view text, const std::vector<std::string>& candidates, std::string otherwise);

/// The allowed names for a message: `"a", "b" or "c"`; "none" if the list is empty.
std::string list_of(const std::vector<std::string>& names);

}  // namespace flowslide
