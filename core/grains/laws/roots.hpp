// SPDX-License-Identifier: GPL-2.0-or-later
//
// Roots in double by Newton iteration, because the square root of a wide vector takes as long as 50 products. They use
// only sums and products, and thus have the same bits on every processor. Float has a fast square root.
#pragma once
#include <bit>
#include <cmath>
#include <cstdint>
#include <type_traits>

#include "grains/laws/fused.hpp"

namespace flowslide::laws {

/// Smallest argument of a reciprocal root; a smaller one would overflow. Clamp the argument, never the number that the
/// root multiplies.
template <typename Real>
inline constexpr Real smallest_argument = std::is_same_v<Real, double> ? Real(1e-200) : Real(1e-37);

/// 1/sqrt(x) within 2 units in the last place, for x >= smallest_argument. The first guess, from the exponent, has an
/// error of at most 3.5 % (Lomont, Fast inverse square root, 2003). Each iteration squares the error and multiplies it
/// by 1.5.
FLOWSLIDE_LANE double inverse_root(double x) {
  double y = std::bit_cast<double>(0x5fe6ec85cfb83998 - (std::bit_cast<std::uint64_t>(x) >> 1));
  const double half = 0.5 * x;
  for (int i = 0; i < 4; ++i) y *= std::fma(-half * y, y, 1.5);
  return y;
}
FLOWSLIDE_LANE float inverse_root(float x) { return 1.0F / std::sqrt(x); }

/// Square root and fourth root of x >= 0, from x^(-1/4). The first guess has an error of at most 3.2 %. Each iteration
/// squares the error and multiplies it by 2.5.
FLOWSLIDE_LANE void two_roots(double x, double& root, double& fourth_root) {
  const double clamped = x > smallest_argument<double> ? x : smallest_argument<double>;
  double z = std::bit_cast<double>(0x4feb0c0b8c253cd1 - (std::bit_cast<std::uint64_t>(clamped) >> 2));
  const double quarter = 0.25 * clamped;
  for (int i = 0; i < 3; ++i) {
    const double squared = z * z;
    z *= std::fma(-quarter * squared, squared, 1.25);
  }
  const double squared = z * z;
  z = std::fma(z, std::fma(-quarter * squared, squared, 0.25), z);  // last iteration as a correction: less rounding
  root = x * (z * z);
  fourth_root = root * z;
}
FLOWSLIDE_LANE void two_roots(float x, float& root, float& fourth_root) {
  root = std::sqrt(x);
  fourth_root = std::sqrt(root);
}

}  // namespace flowslide::laws
