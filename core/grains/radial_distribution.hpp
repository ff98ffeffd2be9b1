// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <vector>

#include "grains/assembly.hpp"

namespace flowslide {

/// Number of pairs of grains at a distance, divided by the number for independent positions. Arrays have shape (bins).
struct RadialDistribution {
  std::vector<double> distance;  ///< middle of each bin, in mean diameters
  std::vector<double> density;   ///< g: 1 without correlation
};

/// The distribution up to `reach` mean diameters, in `bins` equal bins. With a rigid z axis, only the part of a shell
/// inside the cell counts for the independent positions: a shell of radius r loses the fraction (1 - h/r)/2 if its
/// centre is h < r away from a plane. Throws std::invalid_argument unless bins >= 1, reach > 0, there are two grains or
/// more, x and y are periodic, and each periodic length is at least 2 `reach` diameters.
RadialDistribution radial_distribution(const Assembly& assembly, double reach, int bins);

}  // namespace flowslide
