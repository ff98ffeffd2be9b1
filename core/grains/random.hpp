// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <cstdint>
#include <random>

namespace flowslide {

/// The standard fixes the sequence of the engine but not of its distributions: the latter are written out here, in
/// operations that give the same bits on every platform.
using Generator = std::mt19937_64;

/// Uniform in [0, 1) with 53 random bits.
inline double uniform(Generator& generator) { return static_cast<double>(generator() >> 11) * 0x1.0p-53; }

/// Of the mean 0 and the variance 1: the sum of twelve uniform numbers less 6 (Irwin and Hall). Normal up to 3 standard
/// deviations within 0.3 % of the probability, and never beyond 6; it needs no function of a mathematical library.
inline double normal(Generator& generator) {
  double sum = -6.0;
  for (int i = 0; i < 12; ++i) sum += uniform(generator);
  return sum;
}

}  // namespace flowslide
