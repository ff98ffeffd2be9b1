// SPDX-License-Identifier: GPL-2.0-or-later
#include "configuration/canonical.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>

namespace flowslide {
namespace {

TEST(Canonical, WritesNumbersThatTomlReadsAsFloats) {
  EXPECT_EQ(canonical(28340.0), "28340.0");
  EXPECT_EQ(canonical(5e-7), "5e-07");
  EXPECT_EQ(canonical(0.1), "0.1");
  EXPECT_EQ(canonical(1e22), "1e+22");
  EXPECT_EQ(canonical(-0.0), "-0.0");
  EXPECT_EQ(canonical(std::nextafter(0.1, 1.0)), "0.10000000000000002");
}

TEST(Canonical, GivesTheSameDoubleAgain) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> exponent(-300.0, 300.0);
  for (int i = 0; i < 10000; ++i) {
    const double value = std::pow(10.0, exponent(random));
    ASSERT_EQ(std::strtod(canonical(value).c_str(), nullptr), value);
  }
}

TEST(Canonical, WritesOtherValues) {
  EXPECT_EQ(canonical(std::int64_t{-7}), "-7");
  EXPECT_EQ(canonical(true), "true");
  EXPECT_EQ(canonical(false), "false");
  EXPECT_EQ(canonical(std::string_view("a \"b\" \\ c\n")), "\"a \\\"b\\\" \\\\ c\\u000A\"");
}

}  // namespace
}  // namespace flowslide
