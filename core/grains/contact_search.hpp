// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <compare>
#include <cstdint>
#include <vector>

#include "grains/assembly.hpp"

namespace flowslide {

/// Two touching grains, first < second, as indices into the assembly.
struct TouchingPair {
  std::uint32_t first = 0, second = 0;
  auto operator<=>(const TouchingPair&) const = default;  // NOLINT(modernize-use-nullptr): a false alarm of version 14
};

/// The pairs that a search returns.
enum class SearchScope { all_pairs, without_pairs_of_one_layer };

/// True if both grains are glued to the same layer.
bool in_one_layer(const Assembly& assembly, std::uint32_t first, std::uint32_t second);

/// All pairs with |x_1 - x_2| < R_1 + R_2 (nearest image on periodic axes), each once, sorted by (first, second).
/// Grains may be outside the cell. A grid of boxes, at least one largest diameter wide, makes the cost proportional to
/// the number of grains. A periodic axis too short for three boxes is not divided, so that a small sample is searched
/// pair by pair. Periodic lengths must be at least two largest diameters, because a pair counts once even if it touches
/// through two images.
std::vector<TouchingPair> touching_pairs(const Assembly& assembly,
                                         SearchScope scope = SearchScope::without_pairs_of_one_layer);

}  // namespace flowslide
