// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <cstdint>
#include <random>

namespace flowslide {

/// The C++ standard specifies the sequence of this generator, but not that of its distributions. This file therefore
/// contains its own distributions, whose operations give the same bits on every platform.
using Generator = std::mt19937_64;

/// Uniform in [0, 1) with 53 random bits.
inline double uniform(Generator& generator) { return static_cast<double>(generator() >> 11) * 0x1.0p-53; }

/// Approximately normal, with mean 0 and variance 1: the sum of twelve uniform numbers minus 6 (Irwin and Hall). Up to
/// 3 standard deviations it is normal within 0.3 % of the probability, and it never exceeds 6. It needs no function of
/// a mathematical library.
inline double normal(Generator& generator) {
  double sum = -6.0;
  for (int i = 0; i < 12; ++i) sum += uniform(generator);
  return sum;
}

}  // namespace flowslide
