// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <cstddef>

#include "grains/assembly.hpp"

namespace flowslide {

/// How much of a wave there is in the positions of the grains along an axis (0, 1, 2 for x, y, z), with `periods` waves
/// in the length L of the cell: S = |mean over the grains of exp(2 pi i periods (x - x_0)/L)|. 1 if they lie in planes
/// L/periods apart, some 1/sqrt(N) for N independent positions. Layers at planes show as well. Throws
/// std::invalid_argument for no grain, or periods < 1.
double positional_order(const Assembly& assembly, int axis, int periods);

/// Order of a part of the grains, and how many they are.
struct MiddleOrder {
  double value = 0.0;
  std::size_t grains = 0;
};

/// The same over the middle of the cell, where walls make no layers: about 60 % of its length, a whole number of waves,
/// so that a uniform density has none. 0 without grains there.
MiddleOrder middle_order(const Assembly& assembly, int axis, int periods);

/// Order up to which `grains` positions count as random: the mean and so many standard deviations of the order of
/// independent positions. The sum of N random unit vectors is a Gaussian in the plane (K. Pearson, Nature 72 (1905)
/// 294), so that S has Rayleigh's distribution with the mean sqrt(pi/(4 N)) and the variance (1 - pi/4)/N. With two
/// deviations it is 1.81/sqrt(N), exceeded by chance with the probability exp(-1.81^2) = 0.037; with four, 2.74/sqrt(N)
/// and 5e-4.
double order_of_random_positions(std::size_t grains, double deviations);

}  // namespace flowslide
