// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <cstddef>

#include "grains/assembly.hpp"

namespace flowslide {

/// Positional order of the grains along an axis (0, 1, 2 for x, y, z) for a wave with `periods` periods in the length L
/// of the cell: S = |mean over the grains of exp(2 pi i periods (x - x_0)/L)|. S is 1 if the grains form planes with
/// the distance L/periods, and about 1/sqrt(N) for N independent positions. Layers at walls increase S. Throws
/// std::invalid_argument without grains or for periods < 1.
double positional_order(const Assembly& assembly, int axis, int periods);

/// Order of a part of the grains.
struct MiddleOrder {
  double value = 0.0;      ///< S, see positional_order
  std::size_t grains = 0;  ///< number of grains in this part
};

/// The order in the middle of the cell, where walls cause no layers: about 60 % of its length. The part is a whole
/// number of waves long, so that a uniform density has no order. The value is 0 without grains in this part. Throws
/// std::invalid_argument for periods < 1.
MiddleOrder middle_order(const Assembly& assembly, int axis, int periods);

/// Largest order at which the positions of `grains` grains count as random: the mean for independent positions plus
/// `deviations` standard deviations. The sum of N random unit vectors is a Gaussian in the plane (K. Pearson, Nature 72
/// (1905) 294). S therefore has a Rayleigh distribution with the mean sqrt(pi/(4 N)) and the variance (1 - pi/4)/N.
/// With 2 deviations the limit is 1.81/sqrt(N). Random positions exceed it with a probability of 0.037, which is
/// exp(-1.81^2). With 4 deviations it is 2.74/sqrt(N), with a probability of 5e-4.
double order_of_random_positions(std::size_t grains, double deviations);

}  // namespace flowslide
