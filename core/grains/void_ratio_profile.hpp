// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <vector>

#include "grains/assembly.hpp"

namespace flowslide {

/// Void ratios of `slices` equal slices of the cell across an axis (0, 1, 2 for x, y, z), from its lower end on; shape
/// (slices). Each sphere is cut exactly (see volume_below); along a periodic axis its images count. Throws
/// std::invalid_argument for slices < 1, or if a slice holds no solid.
std::vector<double> void_ratio_profile(const Assembly& assembly, int axis, int slices);

/// Number of equal slices across an axis that are nearest to one mean diameter thick.
int slices_of_a_diameter(const Assembly& assembly, int axis);

}  // namespace flowslide
