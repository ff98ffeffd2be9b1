// SPDX-License-Identifier: GPL-2.0-or-later
#include "sample/void_ratio_search.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "sample/failure.hpp"

namespace flowslide {
namespace {

/// An invented preparation with the scatter of real ones; sin(seed) replaces chance.
double made_up(const SampleRecipe& recipe) {
  const double chance = std::sin(12.9898 * static_cast<double>(recipe.packing.seed));
  return 0.72 + 0.16 * recipe.preparation_friction + 0.006 * chance;
}

TEST(VoidRatioSearch, FindsATargetThroughTheScatterOfSeeds) {
  for (const double wanted : {0.74, 0.76, 0.78, 0.80}) {
    SampleRecipe start;
    start.preparation_friction = 0.3;
    const auto trials = search_void_ratio(start, {wanted, 2e-3, 20}, made_up);
    EXPECT_NEAR(trials.back().void_ratio, wanted, 2e-3);
    for (std::size_t i = 0; i + 1 < trials.size(); ++i) EXPECT_GT(std::abs(trials[i].void_ratio - wanted), 2e-3);
  }
}

TEST(VoidRatioSearch, TakesTheFirstSampleIfItFits) {
  SampleRecipe start;
  EXPECT_EQ(search_void_ratio(start, {made_up(start), 1e-6, 5}, made_up).size(), 1u);
}

TEST(VoidRatioSearch, GoesOnToTheNextSeedWhenAPackingFails) {
  SampleRecipe start;
  const std::uint64_t first = start.packing.seed;
  const auto fragile = [&](const SampleRecipe& recipe) {
    if (recipe.packing.seed < first + 2) throw NumericalFailure("collapsed");
    return 0.80;
  };
  const auto trials = search_void_ratio(start, {0.80, 1e-3, 3}, fragile);
  ASSERT_EQ(trials.size(), 1u);
  EXPECT_EQ(trials.front().recipe.packing.seed, first + 2);
  EXPECT_THROW(search_void_ratio(start, {0.80, 1e-3, 2}, fragile), NumericalFailure);
}

TEST(VoidRatioSearch, SaysHowNearItCameWhenTheTargetIsOutOfReach) {
  try {
    search_void_ratio({}, {0.95, 2e-3, 4}, made_up);
    FAIL() << "0.95 was found though the law ends at 0.83";
  } catch (const NumericalFailure& failure) {
    const std::string text = failure.what();
    EXPECT_NE(text.find("0.95"), std::string::npos) << text;
    EXPECT_NE(text.find("larger drag"), std::string::npos) << text;
    EXPECT_NE(text.find("4 trials"), std::string::npos) << text;
  }
}

TEST(VoidRatioSearch, RefusesTargetsThatNoPackingHas) {
  const auto never = [](const SampleRecipe&) -> double { throw std::logic_error("nothing may be prepared"); };
  EXPECT_THROW(search_void_ratio({}, {0.3, 2e-3, 4}, never), std::invalid_argument);
  EXPECT_THROW(search_void_ratio({}, {1.5, 2e-3, 4}, never), std::invalid_argument);
  EXPECT_THROW(search_void_ratio({}, {0.79, 0.0, 4}, never), std::invalid_argument);
  EXPECT_THROW(search_void_ratio({}, {0.79, 2e-3, 0}, never), std::invalid_argument);
}

}  // namespace
}  // namespace flowslide
