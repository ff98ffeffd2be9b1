// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "grains/assembly.hpp"
#include "grains/material.hpp"
#include "grains/vector.hpp"

namespace flowslide {

/// Kinetic stress of the mobile grains, Pa, symmetric, compression positive (eq. 14):
///   <sigma>_k = 1/V sum_p m v' (x) v',
/// v' the velocity about the measured profile: the cell is cut into `sublayers` (>= 1) of equal height, and in each the
/// mean motion is the straight line in z that fits the grains' velocities best, weighted by mass (with fewer than three
/// grains: their mean). The line keeps the shear of the mean motion out of the fluctuations, whether it is spread over
/// the height or localised. Throws std::invalid_argument for sublayers < 1.
Matrix3 kinetic_stress(const Assembly& assembly, const Material& material, int sublayers = 10);

}  // namespace flowslide
