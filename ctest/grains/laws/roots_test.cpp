// SPDX-License-Identifier: GPL-2.0-or-later
// core/grains/laws/roots.hpp, compiled without wide vectors: passes_test.cpp compares the bits of the others.
#include "grains/laws/roots.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <limits>

#include "support/clustered_cloud.hpp"

namespace flowslide::laws {
namespace {

/// Relative error, in units of the spacing of numbers above 1.
template <typename Real>
double units_off(Real found, long double exact) {
  return static_cast<double>(std::fabs(static_cast<long double>(found) / exact - 1.0L)) /
         std::numeric_limits<Real>::epsilon();
}

/// Numbers of every size from `smallest` to `largest`, many of each power of two.
template <typename Real, typename Check>
void for_numbers(Real smallest, Real largest, Check check) {
  Dice dice(1);
  for (Real power = smallest; power < largest / 4; power *= 2)
    for (int i = 0; i < 200; ++i) check(static_cast<Real>(power * static_cast<Real>(dice.between(1.0, 2.0))));
}

template <typename Real>
void expect_roots(Real largest, double inverse_units, double root_units, double fourth_units) {
  double inverse_off = 0.0, root_off = 0.0, fourth_off = 0.0;
  for_numbers<Real>(smallest_argument<Real>, largest, [&](Real x) {
    const long double exact = std::sqrt(static_cast<long double>(x));
    inverse_off = std::max(inverse_off, units_off(inverse_root(x), 1.0L / exact));
    Real root, fourth;
    two_roots(x, root, fourth);
    root_off = std::max(root_off, units_off(root, exact));
    fourth_off = std::max(fourth_off, units_off(fourth, std::sqrt(exact)));
  });
  std::printf("1/sqrt %.2f, sqrt %.2f, fourth root %.2f units off\n", inverse_off, root_off, fourth_off);
  EXPECT_LT(inverse_off, inverse_units);
  EXPECT_LT(root_off, root_units);
  EXPECT_LT(fourth_off, fourth_units);
}

/// The last iteration of 1/sqrt rounds four times, two of them halved; that of the fourth root five times, and the
/// square root is its square (twice the error) times x, the fourth root again times it.
TEST(Roots, OfDoubleAreWithinTheRoundingOfOneIteration) { expect_roots<double>(1e300, 2.0, 4.0, 6.0); }

/// Rounded once or twice.
TEST(Roots, OfFloatAreRoundedOnceOrTwice) { expect_roots<float>(1e37F, 1.5, 0.5, 1.0); }

template <typename Real>
void expect_clamped() {
  Real root = 1, fourth = 1;
  two_roots(Real(0), root, fourth);
  EXPECT_EQ(root, Real(0));
  EXPECT_EQ(fourth, Real(0));
  EXPECT_TRUE(std::isfinite(inverse_root(smallest_argument<Real>)));
  // Below the smallest argument roots may be anything between 0 and those of it, but no less for more.
  Real before_root = 0, before_fourth = 0;
  for (Real x = std::numeric_limits<Real>::denorm_min(); x <= smallest_argument<Real>; x *= 2) {
    two_roots(x, root, fourth);
    EXPECT_GE(root, before_root);
    EXPECT_GE(fourth, before_fourth);
    before_root = root;
    before_fourth = fourth;
  }
  EXPECT_LE(root, std::sqrt(smallest_argument<Real>) * Real(1.000001));
}

TEST(Roots, OfZeroAreZeroAndNoNumberIsInfinite) {
  expect_clamped<double>();
  expect_clamped<float>();
}

}  // namespace
}  // namespace flowslide::laws
