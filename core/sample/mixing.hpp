// SPDX-License-Identifier: GPL-2.0-or-later
// Stage 0 of a preparation: the grains fly about until the order of their initial lattice has vanished.
#pragma once
#include <array>
#include <cstdint>
#include <string>

#include "grains/positional_order.hpp"
#include "sample/recipe.hpp"

namespace flowslide {

/// Positional order at the wave numbers of the lattice along x, y and z, in the middle of the cell.
struct LatticeMemory {
  std::array<MiddleOrder, 3> order;

  /// Whether the order along each axis is as low as in a random packing (see order_of_random_positions).
  bool forgotten() const;
  /// The largest order relative to its limit, its axis and the limit: "0.21 along x, where 0.07 is allowed".
  std::string text() const;
};

LatticeMemory lattice_memory(const Assembly& assembly, const LatticePacking& packing);

/// Steps between two checks of the order: a grain at the mixing velocity moves by one lattice spacing in this time.
std::int64_t steps_between_checks(const SampleRecipe& recipe);

/// Throws std::invalid_argument if the time step is too long for the stiffest impact of the mixing, or if the overlap
/// of this impact exceeds `largest_overlap`. In this impact two of the smallest grains collide head-on, each with a
/// velocity of three standard deviations.
void validate_impacts(const SampleRecipe& recipe);

}  // namespace flowslide
