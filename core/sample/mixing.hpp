// SPDX-License-Identifier: GPL-2.0-or-later
// Stage 0 of a preparation: grains that fly about until the lattice that they began on is forgotten.
#pragma once
#include <array>
#include <cstdint>
#include <string>

#include "grains/positional_order.hpp"
#include "sample/recipe.hpp"

namespace flowslide {

/// Order at the wave numbers of the lattice, over the middle of the cell along x, y and z.
struct LatticeMemory {
  std::array<MiddleOrder, 3> order;

  /// Whether along each axis there is as little as in a random packing (see order_of_random_positions).
  bool forgotten() const;
  /// Where there is most of it, with the value and what is allowed: "0.21 along x, where 0.07 is allowed".
  std::string text() const;
};

LatticeMemory lattice_memory(const Assembly& assembly, const LatticePacking& packing);

/// Steps between two looks at the memory: those in which a grain of the mixing velocity goes the way of one site.
std::int64_t steps_between_looks(const SampleRecipe& recipe);

/// Throws std::invalid_argument if the time step is too long for the stiffest impact of the mixing, that of two of the
/// smallest grains that are each three standard deviations fast, or makes them overlap too much (see largest_overlap).
void validate_impacts(const SampleRecipe& recipe);

}  // namespace flowslide
