// SPDX-License-Identifier: GPL-2.0-or-later
#include "coupling/strain_passing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

namespace flowslide::strain_passing_test {
namespace {

/// A time step that binary fractions divide, so that q is a whole number where the tests say so.
const double step = std::ldexp(1.0, -17);

double applied(const LocalRun& run) { return std::hypot(run.rate.shear, run.rate.compression); }
double strain_of(const LocalRun& run) { return run.rate.shear * run.duration(); }

/// One exchange of `steps` local steps' worth of shear at the rate 1, nothing owed before.
LocalRun pass_steps(const PassingRule& rule, double steps, std::int64_t most = 1000) {
  Strain owed;
  return pass({rule, step, most}, owed, {steps * step, 0.0}, 1.0);
}

const std::vector<PassingRule> all_rules{WholeIncrement{}, AccumulateAndReset{10}, CarryRemainder{10},
                                         VariableTimeStep{}};

TEST(WholeIncrement, RunsFloorAndOneSteps) {
  for (const double steps : {0.25, 0.75, 1.5, 9.5, 100.25}) {
    const LocalRun run = pass_steps(WholeIncrement{}, steps);
    EXPECT_EQ(run.steps, static_cast<std::int64_t>(std::floor(steps)) + 1) << steps;
    EXPECT_DOUBLE_EQ(strain_of(run), steps * step);
    EXPECT_DOUBLE_EQ(applied(run), steps / (std::floor(steps) + 1.0));  // eq. 16: less than asked
  }
}

TEST(AccumulateAndReset, WaitsForTheStepsItWants) {
  const StrainPassing passing{AccumulateAndReset{10}, step, 1000};
  Strain owed;
  for (int n = 1; n <= 8; ++n) EXPECT_EQ(pass(passing, owed, {step, 0.0}, 1.0).steps, 0) << n;
  EXPECT_EQ(owed.shear, 8.0 * step);
  // floor(9) + 1 = 10 steps for the strain of 9: the worst case, low by 1/n_accum.
  const LocalRun run = pass(passing, owed, {step, 0.0}, 1.0);
  EXPECT_EQ(run.steps, 10);
  EXPECT_DOUBLE_EQ(strain_of(run), 9.0 * step);
  EXPECT_DOUBLE_EQ(applied(run), 1.0 - 1.0 / 10.0);
  EXPECT_EQ(owed.norm(), 0.0);
}

TEST(AccumulateAndReset, IsLowByOneOverTheStepsAndOneWhereTheyMeet) {
  for (const std::int64_t least : {10, 30, 100}) {
    const LocalRun run = pass_steps(AccumulateAndReset{least}, static_cast<double>(least));
    EXPECT_EQ(run.steps, least + 1);
    EXPECT_DOUBLE_EQ(applied(run), 1.0 - 1.0 / static_cast<double>(least + 1));
  }
}

TEST(AccumulateAndReset, OfOneStepIsEq15) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> some(-5.0 * step, 5.0 * step);
  Strain owed, owed_whole;
  for (int n = 0; n < 1000; ++n) {
    const Strain increment{some(random), some(random)};
    const LocalRun a = pass({AccumulateAndReset{1}, step, 1000}, owed, increment, 1.0);
    const LocalRun b = pass({WholeIncrement{}, step, 1000}, owed_whole, increment, 1.0);
    EXPECT_EQ(a.steps, b.steps);
    EXPECT_EQ(a.rate.shear, b.rate.shear);
  }
}

TEST(CarryRemainder, PassesWholeStepsAndKeepsTheRest) {
  const StrainPassing passing{CarryRemainder{10}, step, 1000};
  Strain owed;
  EXPECT_EQ(pass(passing, owed, {9.75 * step, 0.0}, 1.0).steps, 0);
  const LocalRun run = pass(passing, owed, {1.0 * step, 0.0}, 1.0);
  EXPECT_EQ(run.steps, 10);
  EXPECT_DOUBLE_EQ(applied(run), 1.0);
  EXPECT_NEAR(owed.shear, 0.75 * step, 1e-12 * step);
}

TEST(CarryRemainder, RoundingDoesNotDelayAStep) {
  const double below = 10.0 * (1.0 - 1e-14);  // what is left of 10 after some divisions
  EXPECT_EQ(pass_steps(CarryRemainder{10}, below).steps, 10);
  EXPECT_EQ(pass_steps(CarryRemainder{10}, 10.0 * (1.0 - 1e-6)).steps, 0);
}

/// Rates that the exchanges of a moving and turning slope were passed at, over those asked for, and the sums.
struct Passed {
  std::vector<double> share;
  Strain given, received, owed;
};

Passed pass_many(const PassingRule& rule, bool turning) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> size(0.0, 25.0 * step), factor(0.5, 2.0);
  Passed passed;
  const StrainPassing passing{rule, step, 1'000'000};
  for (int n = 0; n < 20'000; ++n) {
    const double sign = turning ? std::cos(0.01 * n) : 1.0;
    const Strain increment{sign * size(random), -0.1 * sign * size(random)};
    const double asked = factor(random);
    const LocalRun run = pass(passing, passed.owed, increment, asked);
    passed.given += increment;
    passed.received += run.duration() * Strain{run.rate.shear, run.rate.compression};
    if (run.steps > 0) passed.share.push_back(applied(run) / asked);
  }
  return passed;
}

TEST(StrainPassing, NoRuleLosesStrain) {
  for (const PassingRule& rule : all_rules)
    for (const bool turning : {false, true}) {
      const Passed passed = pass_many(rule, turning);
      // Sums of 20 000 numbers of 1e-4: rounding.
      EXPECT_NEAR(passed.received.shear + passed.owed.shear, passed.given.shear, 1e-12);
      EXPECT_NEAR(passed.received.compression + passed.owed.compression, passed.given.compression, 1e-12);
      EXPECT_LT(passed.owed.norm(), 2.0 * 11.0 * step);  // n_accum steps and one, at the largest rate
    }
}

TEST(StrainPassing, RateAskedIsRateAppliedByTheCarriedRemainderAndByEq17) {
  for (const PassingRule& rule : {PassingRule{CarryRemainder{10}}, PassingRule{VariableTimeStep{}}}) {
    const Passed passed = pass_many(rule, true);
    ASSERT_GT(passed.share.size(), 1000U);
    for (const double share : passed.share) ASSERT_NEAR(share, 1.0, 1e-12);
  }
}

TEST(StrainPassing, PrintedEq18IsLowByUpToOneOverNAccum) {
  const Passed passed = pass_many(AccumulateAndReset{10}, false);
  double lowest = 1.0;
  for (const double share : passed.share) {
    ASSERT_LE(share, 1.0 + 1e-12);
    ASSERT_GE(share, 0.9 - 1e-12);
    lowest = std::min(lowest, share);
  }
  EXPECT_LT(lowest, 0.91);  // the bound is nearly met in 10 000 draws
}

TEST(StrainPassing, LocalClockRunsAheadOnlyAsPrinted) {
  // The rate of a slope, 10 local steps per global one. The printed rule runs 11 of them: 10 % ahead.
  const auto local_over_global = [](const PassingRule& rule) {
    Strain owed;
    double local = 0.0;
    for (int n = 0; n < 1000; ++n) local += pass({rule, step, 1000}, owed, {10.0 * step, 0.0}, 1.0).duration();
    return local / (1000 * 10.0 * step);
  };
  EXPECT_DOUBLE_EQ(local_over_global(AccumulateAndReset{10}), 1.1);
  EXPECT_NEAR(local_over_global(CarryRemainder{10}), 1.0, 1e-12);
  EXPECT_NEAR(local_over_global(VariableTimeStep{}), 1.0, 1e-12);
}

TEST(VariableTimeStep, NeverExceedsItsTimeStep) {
  for (const double steps : {1e-3, 0.5, 1.0, 9.5, 100.0}) {
    const LocalRun run = pass_steps(VariableTimeStep{}, steps);
    EXPECT_EQ(run.steps, static_cast<std::int64_t>(std::floor(steps)) + 1);
    EXPECT_LE(run.time_step, step);
    EXPECT_NEAR(run.duration(), steps * step, 1e-12 * steps * step);
    EXPECT_NEAR(applied(run), 1.0, 1e-12);
  }
}

TEST(StrainPassing, NothingRunsAtRest) {
  for (const PassingRule& rule : all_rules)
    for (const double asked : {0.0, 1.0}) {
      Strain owed;
      const LocalRun run = pass({rule, step, 1000}, owed, {}, asked);  // eq. 15 is 0/0 here
      EXPECT_EQ(run.steps, 0);
      EXPECT_EQ(owed.norm(), 0.0);
    }
}

TEST(StrainPassing, StepsStayBoundedWhenTheRateVanishesWhileStrainIsOwed) {
  for (const PassingRule& rule : all_rules)
    for (const double asked : {1e-30, 1e-9}) {
      const bool carries = std::holds_alternative<CarryRemainder>(rule);
      Strain owed{5.0 * step, 0.0};
      const LocalRun run = pass({rule, step, 1000}, owed, {step, 0.0}, asked);
      EXPECT_EQ(run.steps, 1000);
      EXPECT_EQ(run.time_step, step);
      // Carried, the rate holds and the strain waits; else the strain passes, faster than asked.
      EXPECT_NEAR(strain_of(run), carries ? 1000.0 * asked * step : 6.0 * step, 1e-12 * step);
      EXPECT_NEAR(strain_of(run) + owed.shear, 6.0 * step, 1e-12 * step);
    }
  Strain owed{5.0 * step, 0.0};
  EXPECT_EQ(pass({CarryRemainder{1}, step, 1000}, owed, {}, 0.0).steps, 0);
  EXPECT_EQ(pass({WholeIncrement{}, step, 1000}, owed, {}, 0.0).steps, 1000);
}

TEST(StrainPassing, OppositeStrainsCancelBeforeTheyArePassed) {
  for (const PassingRule& rule : {PassingRule{AccumulateAndReset{10}}, PassingRule{CarryRemainder{10}}}) {
    Strain owed;
    EXPECT_EQ(pass({rule, step, 1000}, owed, {5.0 * step, 0.0}, 1.0).steps, 0);
    EXPECT_EQ(pass({rule, step, 1000}, owed, {-5.0 * step, 0.0}, 1.0).steps, 0);
    EXPECT_EQ(owed.norm(), 0.0);
    const LocalRun run = pass({rule, step, 1000}, owed, {-20.5 * step, 0.0}, 1.0);
    EXPECT_LT(run.rate.shear, 0.0);
  }
}

TEST(StrainPassing, NormIsOverBothStrains) {
  Strain owed;
  const LocalRun run = pass({CarryRemainder{10}, step, 1000}, owed, {12.0 * step, -16.0 * step}, 1.0);
  EXPECT_EQ(run.steps, 20);
  EXPECT_NEAR(run.rate.shear, 0.6, 1e-12);
  EXPECT_NEAR(run.rate.compression, -0.8, 1e-12);
}

TEST(StrainPassing, RefusesValuesOutOfRange) {
  EXPECT_NO_THROW(validate(StrainPassing{}));
  EXPECT_THROW(validate(StrainPassing{CarryRemainder{0}, step, 1000}), std::invalid_argument);
  EXPECT_THROW(validate(StrainPassing{AccumulateAndReset{-3}, step, 1000}), std::invalid_argument);
  EXPECT_THROW(validate(StrainPassing{CarryRemainder{100}, step, 99}), std::invalid_argument);
  EXPECT_THROW(validate(StrainPassing{WholeIncrement{}, 0.0, 1000}), std::invalid_argument);
  EXPECT_THROW(validate(StrainPassing{WholeIncrement{}, std::nan(""), 1000}), std::invalid_argument);
  EXPECT_THROW(validate(StrainPassing{WholeIncrement{}, step, 0}), std::invalid_argument);
}

}  // namespace
}  // namespace flowslide::strain_passing_test
