// SPDX-License-Identifier: GPL-2.0-or-later
#include "sample/sample.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "sample/critical_state_sample.hpp"
#include "sample/elastic_sample.hpp"

namespace flowslide {
namespace {

TEST(LocalRun, LastsItsStepsAndHasNoneBelowZero) {
  const LocalRun run{{0.1, 0.0}, 20, 1e-5};
  EXPECT_DOUBLE_EQ(run.duration(), 2e-4);
  EXPECT_NO_THROW(validate(run));
  LocalRun reversed = run;
  reversed.steps = -1;
  EXPECT_THROW(validate(reversed), std::invalid_argument);
  ElasticSample elastic(ElasticProperties{});
  EXPECT_THROW(elastic.strain(reversed), std::invalid_argument);
  CriticalStateSample critical(CriticalStateProperties{});
  EXPECT_THROW(critical.strain(reversed), std::invalid_argument);
}

}  // namespace
}  // namespace flowslide
