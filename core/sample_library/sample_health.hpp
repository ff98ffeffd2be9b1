// SPDX-License-Identifier: GPL-2.0-or-later
// The health of a sample as metrics of a result.
#pragma once
#include <string>
#include <vector>

#include "record/series.hpp"
#include "sample/packing_health.hpp"

namespace flowslide {

/// Names of the metrics for each axis, here x: void_ratio_spread_x, void_ratio_deviation_x, seam_x, lattice_order_x,
/// middle_order_x, largest_order_x. For the whole sample: void_ratio_counting, coordination_number,
/// mechanical_coordination_number, rattler_share, fabric_anisotropy, and normal and shear stress of both halves.
std::vector<Metric> metrics_of(const PackingHealth& health);

}  // namespace flowslide
