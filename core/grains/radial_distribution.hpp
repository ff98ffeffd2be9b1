// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <vector>

#include "grains/assembly.hpp"

namespace flowslide {

/// How many pairs of centres there are at a distance, over what as many independent positions would have. Arrays have
/// shape (bins).
struct RadialDistribution {
  std::vector<double> distance;  ///< middle of each bin, in mean diameters
  std::vector<double> density;   ///< g: 1 without correlation
};

/// Up to `reach` mean diameters in `bins` equal bins. Along a rigid z axis only that part of a shell is expected that
/// lies in the cell: a shell of the radius r about a centre h below a plane loses the share (1 - h/r)/2. Throws
/// std::invalid_argument unless bins >= 1, reach > 0, and x and y are periodic with at least 2 `reach` diameters.
RadialDistribution radial_distribution(const Assembly& assembly, double reach, int bins);

}  // namespace flowslide
