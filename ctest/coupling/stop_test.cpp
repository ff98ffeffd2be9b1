// SPDX-License-Identifier: GPL-2.0-or-later
#include "coupling/stop.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

namespace flowslide::stop_test {
namespace {

constexpr double step = 1e-3;

TEST(Stop, AtTheEndTimeUpToRounding) {
  SlideState state;
  const StopConditions conditions{0.3};
  state.time = 299 * step;
  EXPECT_EQ(stop_of(state, conditions, step), Stop::not_yet);
  state.time = 300 * step * (1.0 - 1e-15);
  EXPECT_EQ(stop_of(state, conditions, step), Stop::end_time);
}

TEST(Stop, AtTheShearStrain) {
  SlideState state;
  const StopConditions conditions{10.0, 0.5};
  state.strain.shear = 0.499;
  EXPECT_EQ(stop_of(state, conditions, step), Stop::not_yet);
  state.strain.shear = 0.5;
  EXPECT_EQ(stop_of(state, conditions, step), Stop::end_shear_strain);
}

TEST(Stop, AtTheVelocity) {
  SlideState state;
  const StopConditions conditions{.end_velocity = 2.5};
  state.velocity = 2.49;
  EXPECT_EQ(stop_of(state, conditions, step), Stop::not_yet);
  state.velocity = 2.5;
  EXPECT_EQ(stop_of(state, conditions, step), Stop::end_velocity);
}

TEST(Stop, WhenASlideHasComeToRestButNotWhenItHasNotBegun) {
  SlideState state;
  const StopConditions conditions{10.0, 10.0, 0.1};
  EXPECT_EQ(stop_of(state, conditions, step), Stop::not_yet);
  state.largest_velocity = 0.05;
  state.velocity = -0.01;  // a swing on the elastic sample
  EXPECT_EQ(stop_of(state, conditions, step), Stop::not_yet);
  state.largest_velocity = state.velocity = 2.0;
  EXPECT_EQ(stop_of(state, conditions, step), Stop::not_yet);
  state.velocity = -1e-6;
  EXPECT_EQ(stop_of(state, conditions, step), Stop::sliding_stopped);
}

TEST(Stop, RefusesConditionsThatNeverOrAlwaysHold) {
  EXPECT_NO_THROW(validate(StopConditions{}));
  EXPECT_THROW(validate(StopConditions{0.0}), std::invalid_argument);
  EXPECT_THROW(validate(StopConditions{std::numeric_limits<double>::infinity()}), std::invalid_argument);
  EXPECT_THROW(validate(StopConditions{1.0, 0.0}), std::invalid_argument);
  EXPECT_THROW(validate(StopConditions{1.0, 1.0, -1.0}), std::invalid_argument);
  EXPECT_THROW(validate(StopConditions{.end_velocity = 0.0}), std::invalid_argument);
}

}  // namespace
}  // namespace flowslide::stop_test
