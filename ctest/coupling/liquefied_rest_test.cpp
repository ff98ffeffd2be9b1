// SPDX-License-Identifier: GPL-2.0-or-later
#include "coupling/liquefied_rest.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace flowslide {
namespace {

constexpr double increment = 1.0 / 64;  // sums of it are exact
constexpr LiquefiedRest rest{30.0, 4 * increment, 12 * increment};

TEST(LiquefiedRest, GivesASampleThatBearsStressAllStrain) {
  RestState state;
  for (int n = 0; n < 100; ++n) EXPECT_FALSE(rests(rest, state, increment, 30.1));
}

TEST(LiquefiedRest, ProbesAndRestsByTurns) {
  RestState state;
  for (int cycle = 0; cycle < 3; ++cycle) {
    for (int n = 0; n < 4; ++n) EXPECT_FALSE(rests(rest, state, increment, 30.0)) << n;
    for (int n = 0; n < 12; ++n) EXPECT_TRUE(rests(rest, state, increment, 0.0)) << n;
  }
}

TEST(LiquefiedRest, StartsAnewWhenStrengthComesBack) {
  RestState state;
  for (int n = 0; n < 3; ++n) rests(rest, state, increment, 0.0);
  EXPECT_FALSE(rests(rest, state, increment, 1000.0));
  for (int n = 0; n < 4; ++n) EXPECT_FALSE(rests(rest, state, increment, 0.0)) << n;
  EXPECT_TRUE(rests(rest, state, increment, 0.0));
}

TEST(LiquefiedRest, RefusesWhatIsNoStressOrStrain) {
  for (const LiquefiedRest& wrong : {LiquefiedRest{0.0, 0.01, 0.1}, {30.0, 0.0, 0.1}, {30.0, 0.01, -1.0}})
    EXPECT_THROW(validate(wrong), std::invalid_argument);
  EXPECT_NO_THROW(validate(LiquefiedRest{}));
}

}  // namespace
}  // namespace flowslide
