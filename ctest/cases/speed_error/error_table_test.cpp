// SPDX-License-Identifier: GPL-2.0-or-later
#include "error_table.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "runs.hpp"

namespace flowslide {
namespace {

constexpr double rounding = 1e-12;

TEST(ErrorOf, IsTheMeanDifferenceOnTheSameSeeds) {
  const QuantityError error = error_of(pulses({1.2, 2.2, 3.5}), pulses({1.0, 2.0, 3.0}), "largest_velocity");
  EXPECT_NEAR(error.error, 0.3 / 2.0, rounding);
  EXPECT_NEAR(error.standard_error, std::sqrt(0.03) / std::sqrt(3.0) / 2.0, rounding);
  EXPECT_NEAR(error.spread, 1.0, rounding);
  EXPECT_NEAR(error.at_most(), 0.15 + 0.1, rounding);
  EXPECT_NEAR(error.at_least(), 0.15 - 0.1, rounding);
}

TEST(ErrorOf, IsNotSmallForUnrelatedSamplesWhoseDifferencesAverageOut) {
  const QuantityError error = error_of(pulses({3.0, 2.0, 1.0}), pulses({1.0, 2.0, 3.0}), "largest_velocity");
  EXPECT_NEAR(error.error, 0.0, rounding);
  EXPECT_GT(error.at_most(), 1.0);
}

TEST(ErrorOf, LeavesOutSeedsThatOneLacksButNotFromTheSpread) {
  const QuantityError error = error_of(pulses({1.2}), pulses({1.0, 2.0, 3.0}), "largest_velocity");
  EXPECT_NEAR(error.error, 0.1, rounding);
  EXPECT_TRUE(std::isnan(error.standard_error));  // one difference has no standard error
  EXPECT_TRUE(std::isnan(error.at_most()));
  EXPECT_NEAR(error.spread, 1.0, rounding);
}

TEST(ErrorOf, IsNoneWhereARunLacksTheQuantity) {
  Ensemble broken = pulses({1.2, 2.2, 3.5});
  broken[1].metrics.erase(broken[1].metrics.begin());
  EXPECT_TRUE(std::isnan(error_of(broken, pulses({1.0, 2.0, 3.0}), "largest_velocity").error));
  EXPECT_TRUE(std::isnan(error_of(pulses({1.0, 2.0, 3.0}), broken, "largest_velocity").error));
  EXPECT_TRUE(std::isnan(error_of(pulses({}), pulses({1.0, 2.0}), "largest_velocity").error));
}

const Axis step{"pulse_dt_L", "dt_L", Scene::pulse, "pulse_fine", {"pulse", "pulse_coarse", "pulse_not_run"}, true};
const Axis model{"pulse_floor", "floor", Scene::pulse, "pulse_fine", {"pulse_other"}, false};

Ensembles runs() {
  return {{"pulse_fine", pulses({1.0, 2.0, 3.0}, 100.0)},
          {"pulse", pulses({1.1, 2.1, 3.1}, 10.0)},
          {"pulse_coarse", pulses({4.0, 5.0, 6.0}, 5.0)},
          {"pulse_other", pulses({1.0, 2.0, 3.0}, 1.0)}};
}

TEST(ErrorsOf, GoesByCostAndKeepsTheWorstQuantity) {
  const std::vector<Axis> axes{step, model};
  const auto rows = errors_of(axes, runs());
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0].setting, "pulse_other");
  EXPECT_EQ(rows[1].setting, "pulse_coarse");
  EXPECT_EQ(rows[1].worst, "largest_velocity");
  EXPECT_NEAR(rows[1].error_over_spread, 1.5, rounding);
  EXPECT_FALSE(rows[1].below_noise());
  EXPECT_NEAR(rows[2].error_over_spread, 0.05, rounding);
  EXPECT_TRUE(rows[2].below_noise());
  EXPECT_EQ(rows[2].grain_steps, 1e8);
  EXPECT_EQ(rows[2].seconds, 10.0);
}

TEST(ErrorsOf, LeavesOutAnAxisWhoseReferenceHasOneSeed) {
  Ensembles few = runs();
  few["pulse_fine"] = pulses({2.0}, 100.0);  // one replicate has no spread
  const std::vector<Axis> axes{step};
  EXPECT_TRUE(errors_of(axes, few).empty());
}

TEST(ErrorsOf, TakesAMissingQuantityForTheLargestError) {
  Ensembles broken = runs();
  broken["pulse"][0].metrics.erase(broken["pulse"][0].metrics.begin());
  const std::vector<Axis> axes{step};
  const auto rows = errors_of(axes, broken);
  EXPECT_TRUE(std::isinf(rows[1].error_over_spread));
  EXPECT_FALSE(rows[1].below_noise());
}

TEST(Candidates, AreThoseThatCompeteAndTheCheapestBelowTheNoiseIsRecommended) {
  const std::vector<Axis> axes{step, model};
  const auto candidates = candidates_of(errors_of(axes, runs()), Scene::pulse);
  ASSERT_EQ(candidates.size(), 2U);
  EXPECT_EQ(candidates[0].setting, "pulse_coarse");
  EXPECT_TRUE(candidates[0].on_front);
  EXPECT_TRUE(candidates[1].on_front);
  ASSERT_NE(recommended(candidates), nullptr);
  EXPECT_EQ(recommended(candidates)->setting, "pulse");
  EXPECT_EQ(recommended(candidates_of(errors_of(axes, runs()), Scene::trigger)), nullptr);
}

TEST(Candidates, HaveTheLargestErrorOfAllTheirAxes) {
  Axis other = step;
  other.reference = "pulse_coarse";
  other.settings = {"pulse"};
  const std::vector<Axis> axes{step, other};
  const auto candidates = candidates_of(errors_of(axes, runs()), Scene::pulse);
  EXPECT_NEAR(candidates[1].error_over_spread, 2.9 / 2.0, rounding);
  EXPECT_EQ(recommended(candidates), nullptr);
}

}  // namespace
}  // namespace flowslide
