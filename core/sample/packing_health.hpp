// SPDX-License-Identifier: GPL-2.0-or-later
// Whether a prepared sample is even and random, in numbers.
#pragma once
#include <array>
#include <string>

#include "grains/contact_network.hpp"
#include "grains/positional_order.hpp"
#include "grains/stress.hpp"
#include "sample/recipe.hpp"

namespace flowslide {

/// How even a sample is across one axis. Void ratios are of slices of one mean diameter; if the axis had walls, their
/// layers are left out (see without_wall_layers).
struct AxisHealth {
  int slices = 0;                  ///< that are looked at
  double spread = 0.0;             ///< standard deviation of their void ratios
  double largest_deviation = 0.0;  ///< of one from their mean, without sign
  double seam = 0.0;               ///< mean of the middle third less the mean of the others: positive, it is loose
  double counting = 0.0;           ///< standard deviation of the void ratio of a slice of a random packing
  double lattice_order = 0.0;      ///< at the wave number of the lattice, over the whole cell (see positional_order)
  MiddleOrder middle_order;        ///< the same over the middle of the cell, away from layers at walls
  double largest_order = 0.0;      ///< the largest with 8 to 30 waves in the cell; layers at walls show
};

struct PackingHealth {
  std::array<AxisHealth, 3> axes;  ///< x, y, z
  ContactNetwork network;
  /// Stress of the lower and the upper half, without a mean diameter at glued layers.
  SlopeStress lower_half, upper_half;
};

/// Health of the sample that a recipe has prepared.
PackingHealth packing_health(const Assembly& sample, const SampleRecipe& recipe);

/// What is not as in a random packing of that size, with value, limit and how to mend it; empty if all is. Spread,
/// deviation, seam and order may exceed the expectation by 4 standard deviations, so that fewer than 1 in 100 random
/// packings are refused. Of several, what exceeds its limit most.
std::string unevenness(const PackingHealth& health);

}  // namespace flowslide
