// SPDX-License-Identifier: GPL-2.0-or-later
#include "slope/sliding.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace flowslide::sliding_test {
namespace {

const SlopeProperties slope;  // m = 3100 kg/m^2, h_s = 0.2 m
constexpr double mass = 3100.0, modulus = 15e6;
const double omega = std::sqrt(modulus / (0.2 * mass));

/// Largest |x| of a slide that swings freely on a spring of G/h_s for a number of steps, from a velocity of 1 m/s.
double largest_swing(double time_step, int steps) {
  const Sliding sliding(slope, time_step);
  SlidingState state = sliding.start(1.0, 0.0, 0.0);
  double largest = 0.0;
  for (int n = 0; n < steps; ++n) {
    sliding.move(state);
    sliding.accelerate(state, 0.0, modulus * state.displacement / 0.2);
    largest = std::max(largest, std::abs(state.displacement));
  }
  return largest;
}

/// Error of x after one radian of that swing, over its amplitude.
double error_of_swing(int steps) {
  const double time_step = 1.0 / (omega * steps);
  const Sliding sliding(slope, time_step);
  SlidingState state = sliding.start(1.0, 0.0, 0.0);
  for (int n = 0; n < steps; ++n) {
    sliding.move(state);
    sliding.accelerate(state, 0.0, modulus * state.displacement / 0.2);
  }
  return std::abs(state.displacement * omega - std::sin(1.0));
}

TEST(Sliding, FallsAsUnderAConstantForce) {
  const double step = 0.01;
  const Sliding sliding(slope, step);
  SlidingState state = sliding.start(2.0, 6200.0, 0.0);  // a = 2 m/s^2
  double velocity = 2.0;
  for (int n = 0; n < 100; ++n) {
    EXPECT_DOUBLE_EQ(sliding.move(state), step * (velocity + 0.5 * step * 2.0));
    velocity = sliding.accelerate(state, 6200.0, 0.0);
  }
  // Central differences are exact for a parabola: v = 2 + 2 t, x = 2 t + t^2. Rounding of a hundred sums.
  EXPECT_NEAR(velocity, 4.0, 1e-13);
  EXPECT_NEAR(state.displacement, 3.0, 1e-13);
  EXPECT_NEAR(state.velocity, 4.0 + step, 1e-13);
}

TEST(Sliding, ResistanceBrakes) {
  const Sliding sliding(slope, 0.01);
  SlidingState state = sliding.start(0.0, 0.0, 3100.0);
  EXPECT_DOUBLE_EQ(state.velocity, -0.005);  // half a step of a = -1 m/s^2
  EXPECT_DOUBLE_EQ(sliding.accelerate(state, 0.0, 3100.0), -0.01);
}

TEST(Sliding, IsOfSecondOrder) {
  // To leading order in h = omega dt the frequency is h^2/24 too high and the amplitude h^2/8 too large.
  const double coarse = error_of_swing(100), fine = error_of_swing(200);
  EXPECT_NEAR(std::log2(coarse / fine), 2.0, 1e-3);  // the next term is a share h^2 = 1e-4 of it
  EXPECT_NEAR(fine, (std::cos(1.0) / 24.0 + std::sin(1.0) / 8.0) / 4e4, 1e-3 * fine);
}

TEST(Sliding, GrowsBeyondTwoOverOmega) {
  const double limit = sliding_time_step_limit(slope, modulus);
  EXPECT_NEAR(limit, 2.0 / omega, 1e-12 * limit);
  // Below, x stays within v/omega/sqrt(1 - (omega dt/2)^2): 7.1 v/omega one percent below the limit.
  EXPECT_LT(largest_swing(0.99 * limit, 10'000) * omega, 7.2);
  // Above, it grows by more than exp(2 sqrt(2 * 1 %)) = 1.32 per step.
  EXPECT_GT(largest_swing(1.01 * limit, 200) * omega, 1e20);
}

TEST(Sliding, RefusesAnInvalidTimeStep) {
  for (const double step : {0.0, -1e-4, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(Sliding(slope, step), std::invalid_argument) << step;
  EXPECT_THROW(sliding_time_step_limit(slope, 0.0), std::invalid_argument);
}

}  // namespace
}  // namespace flowslide::sliding_test
