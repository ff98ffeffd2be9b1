// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "grains/assembly.hpp"
#include "grains/material.hpp"
#include "grains/vector.hpp"

namespace flowslide {

/// Kinetic stress of the mobile grains, Pa, symmetric, compression positive (eq. 14):
///   <sigma>_k = 1/V sum_p m v' (x) v',
/// with the velocity v' relative to the mean motion. The cell is divided into `sublayers` (>= 1) of equal height. In
/// each sublayer the mean motion is the straight line in z that fits the grain velocities best, weighted by mass (with
/// fewer than three grains: their mean). The line removes the mean shear from the fluctuations, for a uniform and for a
/// localised shear. Throws std::invalid_argument for sublayers < 1.
Matrix3 kinetic_stress(const Assembly& assembly, const Material& material, int sublayers = 10);

}  // namespace flowslide
