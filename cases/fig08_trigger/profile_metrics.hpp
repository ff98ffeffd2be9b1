// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <vector>

#include "record/series.hpp"

namespace flowslide {

/// Metrics of the uniformity of a sample, from its profiles (see ProfileRecord). i is the number of the profile.
///   linearity_<i>          R^2 of a straight line through v_x
///   shear_top_<i>          mean <tau>/tau of the three sublayers below the highest one
///   shear_bottom_<i>       mean <tau>/tau of the three sublayers above the lowest one
///   normal_unevenness_<i>  largest difference of <sigma>/sigma from its mean over the height, divided by this mean
/// The same with the prefix "snapshot_" or "mean_" of the other columns of a profile with several snapshots.
/// The highest and the lowest sublayer are left out of the stresses, because they overlap with the glued layers.
std::vector<Metric> profile_metrics(const Series& profiles);

}  // namespace flowslide
