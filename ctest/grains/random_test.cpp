// SPDX-License-Identifier: GPL-2.0-or-later
#include "grains/random.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace flowslide::random_test {
namespace {

constexpr int count = 100'000;

TEST(Random, UniformNumbersHaveTheirMomentsAndBounds) {
  Generator generator(1);
  double sum = 0.0, squares = 0.0;
  for (int i = 0; i < count; ++i) {
    const double u = uniform(generator);
    EXPECT_TRUE(u >= 0.0 && u < 1.0);
    sum += u;
    squares += u * u;
  }
  // Standard deviations of u, 0.289, and of u^2, 0.298, over sqrt(count): five of them.
  EXPECT_NEAR(sum / count, 0.5, 5 * 0.289 / std::sqrt(count));
  EXPECT_NEAR(squares / count, 1.0 / 3.0, 5 * 0.298 / std::sqrt(count));
}

TEST(Random, NormalNumbersHaveTheMomentsOfANormalOne) {
  Generator generator(2);
  double sum = 0.0, squares = 0.0, within = 0.0;
  for (int i = 0; i < count; ++i) {
    const double x = normal(generator);
    EXPECT_LE(std::abs(x), 6.0);
    sum += x;
    squares += x * x;
    within += std::abs(x) < 1.0;
  }
  EXPECT_NEAR(sum / count, 0.0, 5 / std::sqrt(count));
  EXPECT_NEAR(squares / count, 1.0, 5 * std::sqrt(2.0 / count));
  // A normal distribution has 0.6827 within one standard deviation; the sum of twelve differs by the documented 0.3 %.
  EXPECT_NEAR(within / count, 0.6827, 0.003 + 5 * 0.47 / std::sqrt(count));
}

TEST(Random, HasTheBitsOfEveryPlatform) {
  // std::mt19937_64 is fixed by the standard: its 10000th number of the default seed is 9981545732273789042.
  Generator generator;
  generator.discard(9999);
  EXPECT_EQ(uniform(generator), static_cast<double>(9981545732273789042ULL >> 11) * 0x1.0p-53);
}

}  // namespace
}  // namespace flowslide::random_test
