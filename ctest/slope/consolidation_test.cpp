// SPDX-License-Identifier: GPL-2.0-or-later
#include "slope/consolidation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace flowslide {
namespace {

constexpr double modulus = 40e6, start = 10e3;  // Pa

SlopeProperties draining(double conductivity) {
  SlopeProperties slope;
  slope.hydraulic_conductivity = conductivity;
  return slope;
}

/// Oedometric modulus of the scheme and of the sample, Pa.
struct Moduli {
  double assumed = modulus, real = modulus;
};

/// p_w after some steps, Pa.
double excess_after(ConsolidationScheme scheme, double conductivity, double time_step, int steps,
                    const Moduli& moduli = {}) {
  const Consolidation consolidation(draining(conductivity), scheme, time_step, moduli.assumed);
  double excess = start;
  for (int n = 0; n < steps; ++n) excess -= moduli.real * consolidation.increment(excess, 0.0);
  return excess;
}

TEST(Consolidation, CoefficientIsThatOfEq5) {
  // 2 * 4e-5 / (9810 * (0.2 * 0.9961947)^2) = 8e-5 / 389.41948 = 2.054340e-7; tolerance: the digits written.
  EXPECT_NEAR(consolidation_coefficient(draining(4e-5)), 2.054341e-7, 5e-14);
  EXPECT_EQ(consolidation_coefficient(draining(0.0)), 0.0);
}

TEST(Consolidation, NothingDrainsWithoutConductivity) {
  for (const auto scheme : {ConsolidationScheme::euler, ConsolidationScheme::exponential})
    EXPECT_EQ(Consolidation(draining(0.0), scheme, 1e-3, modulus).increment(start, 0.0), 0.0);
}

TEST(Consolidation, ExcessPressureMakesTheLayerThinner) {
  for (const auto scheme : {ConsolidationScheme::euler, ConsolidationScheme::exponential}) {
    const Consolidation consolidation(draining(1e-5), scheme, 1e-3, modulus);
    EXPECT_GT(consolidation.increment(start, 0.0), 0.0);
    EXPECT_LT(consolidation.increment(-start, 0.0), 0.0);  // suction draws water in
  }
}

TEST(Consolidation, EulerIsAsPrinted) {
  const Consolidation consolidation(draining(4e-5), ConsolidationScheme::euler, 1e-3, modulus);
  EXPECT_DOUBLE_EQ(consolidation.increment(start, 0.0), 1e-3 * consolidation_coefficient(draining(4e-5)) * start);
  EXPECT_EQ(consolidation.increment(start, 1e-4), consolidation.increment(start, 0.0));  // it knows no modulus
}

TEST(Consolidation, EulerIsOfFirstOrder) {
  const double rate = consolidation_coefficient(draining(1e-3)) * modulus;
  const auto error = [&](int steps) {
    return std::abs(excess_after(ConsolidationScheme::euler, 1e-3, 1.0 / (rate * steps), steps) / start -
                    std::exp(-1.0));
  };
  // The error is dt/2 of the exponent to leading order, and the next term is a share dt of it.
  EXPECT_NEAR(std::log2(error(500) / error(1000)), 1.0, 0.005);
  EXPECT_NEAR(error(1000), std::exp(-1.0) / 2000.0, 0.005 * error(1000));
}

TEST(Consolidation, EulerGrowsBeyondItsLimit) {
  // gamma_w (h_s cos theta)^2/(k M) = 0.24 s at k = 4e-5 m/s and 10 ms at 1e-3 m/s, to the digits written.
  EXPECT_NEAR(consolidation_time_step_limit(draining(4e-5), modulus), 0.24, 0.005);
  EXPECT_NEAR(consolidation_time_step_limit(draining(1e-3), modulus), 0.010, 5e-4);
  const double limit = consolidation_time_step_limit(draining(1e-3), modulus);
  // Each step multiplies p_w by 1 - 2 dt/limit.
  EXPECT_NEAR(excess_after(ConsolidationScheme::euler, 1e-3, 0.99 * limit, 1000) / start, std::pow(0.98, 1000), 1e-12);
  EXPECT_GT(std::abs(excess_after(ConsolidationScheme::euler, 1e-3, 1.01 * limit, 1000)), 1e8 * start);
  EXPECT_EQ(consolidation_time_step_limit(draining(0.0), modulus), std::numeric_limits<double>::infinity());
}

TEST(Consolidation, ExponentialIsExactForAConstantModulusAtAnyStep) {
  const double rate = consolidation_coefficient(draining(1e-3)) * modulus;
  for (const double decay : {1e-6, 0.1, 1.0, 30.0}) {
    const double exact = start * std::exp(-decay);
    // Each step takes a difference of numbers of the size of p_w: rounding.
    EXPECT_NEAR(excess_after(ConsolidationScheme::exponential, 1e-3, decay / rate, 1), exact, 1e-12 * start);
    EXPECT_NEAR(excess_after(ConsolidationScheme::exponential, 1e-3, decay / rate / 7.0, 7), exact, 1e-12 * start);
  }
}

TEST(Consolidation, ExponentialKnowsWhatTheSampleWillAnswer) {
  // The sample is asked once, after ten steps whose strain it is owed.
  const double rate = consolidation_coefficient(draining(1e-3)) * modulus;
  const Consolidation consolidation(draining(1e-3), ConsolidationScheme::exponential, 0.1 / rate, modulus);
  double owed = 0.0;
  for (int n = 0; n < 10; ++n) owed += consolidation.increment(start, owed);
  EXPECT_NEAR(start - modulus * owed, start * std::exp(-1.0), 1e-12 * start);
}

TEST(Consolidation, ExponentialIsStableUnderAnUpperBoundOfTheModulus) {
  // A sample 1 to 100 times softer than the bound, at a step of 100 Euler limits: p_w falls and never turns.
  const double step = 100.0 * consolidation_time_step_limit(draining(1e-3), modulus);
  for (const double share : {1.0, 0.5, 0.01}) {
    const double after =
        excess_after(ConsolidationScheme::exponential, 1e-3, step, 3, {.real = share * modulus}) / start;
    EXPECT_NEAR(after, std::pow(1.0 - share, 3), 1e-12) << share;
  }
  // Below half the real modulus it is no bound, and grows.
  EXPECT_GT(std::abs(excess_after(ConsolidationScheme::exponential, 1e-3, step, 100, {.assumed = 0.4 * modulus})),
            1e10 * start);
}

TEST(Consolidation, RefusesWhatIsNoStepOrModulus) {
  const auto make = [](double step, double m) {
    Consolidation(draining(1e-5), ConsolidationScheme::exponential, step, m);
  };
  EXPECT_THROW(make(0.0, modulus), std::invalid_argument);
  EXPECT_THROW(make(-1.0, modulus), std::invalid_argument);
  EXPECT_THROW(make(1e-3, 0.0), std::invalid_argument);
  EXPECT_THROW(consolidation_time_step_limit(draining(1e-5), -1.0), std::invalid_argument);
  EXPECT_THROW(consolidation_coefficient(draining(-1e-5)), std::invalid_argument);
}

}  // namespace
}  // namespace flowslide
