// SPDX-License-Identifier: GPL-2.0-or-later
#include "dem/native/passes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <string>

#include "moving_bodies.hpp"
#include "random_pairs.hpp"

namespace flowslide::native {
namespace {

template <typename Real>
class PassesOf : public testing::Test {};
using Precisions = testing::Types<double, float>;
TYPED_TEST_SUITE(PassesOf, Precisions);

template <typename T>
void expect_same_bytes(const std::vector<T>& a, const std::vector<T>& b, const std::string& where) {
  ASSERT_EQ(a.size(), b.size());
  EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(T)), 0) << where;
}

TYPED_TEST(PassesOf, EveryInstructionSetGivesTheSameBitsOfContacts) {
  for (const Material& material : materials())
    for (const bool shared : {false, true}) {
      RandomPairs<TypeParam> start(5, material);
      if (shared) start.share_first();
      RandomPairs<TypeParam> expected = start;
      expected.evaluate(passes<TypeParam>("baseline"));
      for (const std::string& set : instruction_sets()) {
        RandomPairs<TypeParam> pairs = start;
        pairs.evaluate(passes<TypeParam>(set));
        expect_same_bytes(pairs.loads, expected.loads, set);
        expect_same_bytes(pairs.across, expected.across, set);
        for (std::size_t h = 0; h < 6; ++h) expect_same_bytes(pairs.history[h], expected.history[h], set);
      }
    }
}

TYPED_TEST(PassesOf, EveryInstructionSetGivesTheSameBitsOfGrains) {
  for (const MotionPart part : {MotionPart::end, MotionPart::begin, MotionPart::end_and_begin}) {
    MovingBodies<TypeParam> expected;
    const Passes<TypeParam> baseline = passes<TypeParam>("baseline");
    const MotionExtremes extremes = expected.move(baseline, part);
    const double slack = expected.slack(baseline);
    const Moments moments = expected.moments(baseline);
    for (const std::string& set : instruction_sets()) {
      MovingBodies<TypeParam> moving;
      const Passes<TypeParam> here = passes<TypeParam>(set);
      const MotionExtremes found = moving.move(here, part);
      EXPECT_EQ(found.fluctuation_squared, extremes.fluctuation_squared) << set;
      EXPECT_EQ(found.outside, extremes.outside) << set;
      EXPECT_EQ(moving.slack(here), slack) << set;
      const Moments sums = moving.moments(here);
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_EQ(sums.height_times_force[axis], moments.height_times_force[axis]) << set;
        EXPECT_EQ(sums.moment[axis], moments.moment[axis]) << set;
      }
      EXPECT_EQ(sums.inside, moments.inside) << set;
      expect_same_bytes(moving.bodies, expected.bodies, set);
      expect_same_bytes(moving.published, expected.published, set);
      expect_same_bytes(moving.loads, expected.loads, set);
    }
  }
}

TEST(Passes, KnowTheirInstructionSetsAndNoOther) {
  const auto sets = instruction_sets();
  ASSERT_FALSE(sets.empty());
  EXPECT_EQ(sets.front(), "baseline");
  for (const std::string& set : sets) std::printf("instruction set %s\n", set.c_str());
  for (const char* unknown : {"sse", "", "AVX2"})
    try {
      passes<float>(unknown);
      FAIL() << "there is an instruction set '" << unknown << "'";
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find("baseline"), std::string::npos);
    }
}

}  // namespace
}  // namespace flowslide::native
