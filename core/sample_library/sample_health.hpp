// SPDX-License-Identifier: GPL-2.0-or-later
// The health of a sample as numbers of a result.
#pragma once
#include <string>
#include <vector>

#include "record/series.hpp"
#include "sample/packing_health.hpp"

namespace flowslide {

/// Per axis: void_ratio_spread_x, void_ratio_deviation_x, seam_x, lattice_order_x, middle_order_x, largest_order_x. Of
/// the whole: void_ratio_counting, coordination_number, mechanical_coordination_number, rattler_share,
/// fabric_anisotropy and the stresses of the two halves.
std::vector<Metric> metrics_of(const PackingHealth& health);

}  // namespace flowslide
