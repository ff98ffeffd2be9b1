// SPDX-License-Identifier: GPL-2.0-or-later
// Measures of whether a prepared sample is uniform and random.
#pragma once
#include <array>
#include <string>

#include "grains/contact_network.hpp"
#include "grains/positional_order.hpp"
#include "grains/stress.hpp"
#include "sample/recipe.hpp"

namespace flowslide {

/// Uniformity of a sample along one axis. Void ratios are those of slices normal to the axis, about one mean diameter
/// thick. Unless the recipe has `periodic_height`, the axis had walls, and their layers are left out (see
/// without_wall_layers).
struct AxisHealth {
  int slices = 0;                  ///< number of slices used
  double spread = 0.0;             ///< standard deviation of their void ratios
  double largest_deviation = 0.0;  ///< largest |e - mean| of a slice
  double seam = 0.0;               ///< mean e of the middle third minus that of the others; positive: a loose middle
  double counting = 0.0;           ///< expected standard deviation for a random packing (see counting_deviation)
  double lattice_order = 0.0;      ///< order at the wave number of the lattice in the whole cell (see positional_order)
  MiddleOrder middle_order;        ///< the same in the middle of the cell, away from layers at walls
  double largest_order = 0.0;      ///< largest order for 8 to 30 waves in the cell, layers at walls included
};

struct PackingHealth {
  std::array<AxisHealth, 3> axes;  ///< x, y, z
  ContactNetwork network;
  /// Stress of the lower and the upper half. One mean diameter next to each glued layer is left out.
  SlopeStress lower_half, upper_half;
};

/// Measures `sample`, which `recipe` has prepared.
PackingHealth packing_health(const Assembly& sample, const SampleRecipe& recipe);

/// Describes the measure that exceeds its limit most, with value, limit and remedy. Empty if all measures are as in a
/// random packing of the same size. Limits: spread, deviation, seam and order may exceed their expectation by 4
/// standard deviations, which refuses fewer than 1 in 100 random packings.
std::string unevenness(const PackingHealth& health);

}  // namespace flowslide
