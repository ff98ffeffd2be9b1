// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <vector>

#include "record/series.hpp"

namespace flowslide {

/// How uniform a sample is, from its profiles (see ProfileRecord), for each of them by its number i:
///   linearity_<i>          R^2 of a straight line through v_x
///   shear_top_<i>          mean <tau>/tau of the three sublayers below the topmost
///   shear_bottom_<i>       the same of the three above the lowest
///   normal_unevenness_<i>  largest difference of <sigma>/sigma from its mean, over that mean
/// The topmost and the lowest sublayer do not count for stress: they lie partly behind the glued layers.
std::vector<Metric> profile_metrics(const Series& profiles);

}  // namespace flowslide
