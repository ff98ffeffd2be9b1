// SPDX-License-Identifier: GPL-2.0-or-later
#include "coupling/adaptive_time_step.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <utility>

#include "sample/elastic_sample.hpp"

namespace flowslide {
namespace {

/// A sample whose stable step is set by hand.
class Stiff : public ElasticSample {
 public:
  Stiff() : ElasticSample(ElasticProperties{}) {}
  double stable_time_step() override {
    ++asked;
    return stable;
  }
  double stable = 1e-5;  // s
  int asked = 0;
};

TEST(AdaptiveTimeStep, FollowsTheSampleBetweenItsBounds) {
  Stiff sample;
  for (const auto& [stable, expected] : {std::pair{5e-6, 1e-5}, {2e-5, 2e-5}, {9e-5, 4e-5}}) {
    AdaptiveTimeStepState state;
    sample.stable = stable;
    EXPECT_EQ(choose_time_step({}, sample, state), expected);
    EXPECT_EQ(state.time_step, expected);
  }
}

TEST(AdaptiveTimeStep, AsksTheSampleAfterEachInterval) {
  Stiff sample;
  AdaptiveTimeStepState state;
  for (int run = 0; run < 10; ++run) {
    choose_time_step({.interval = 100}, sample, state);
    state.steps += 40;  // as a slide does after a run of 40 steps
  }
  EXPECT_EQ(sample.asked, 4);  // before the runs 1, 4, 7 and 10
}

TEST(AdaptiveTimeStep, OfAClosedFormIsTheLargest) {
  ElasticSample sample(ElasticProperties{});
  AdaptiveTimeStepState state;
  EXPECT_EQ(choose_time_step({}, sample, state), 4e-5);
}

TEST(AdaptiveTimeStep, RefusesALargestStepBelowTheSmallest) {
  EXPECT_NO_THROW(validate(AdaptiveTimeStep{1e-5, 1e-5}));
  EXPECT_THROW(validate(AdaptiveTimeStep{1e-5, 0.9e-5}), std::invalid_argument);
  EXPECT_THROW(validate(AdaptiveTimeStep{1e-5, std::numeric_limits<double>::infinity()}), std::invalid_argument);
  EXPECT_THROW(validate(AdaptiveTimeStep{0.0, 1e-5}), std::invalid_argument);
  EXPECT_THROW(validate(AdaptiveTimeStep{1e-5, 1e-4, 0}), std::invalid_argument);
}

}  // namespace
}  // namespace flowslide
