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
  for (const LawVariant variant : variants)
    for (const bool shared : {false, true}) {
      RandomPairs<TypeParam> start(5);
      if (shared) start.share_first();
      RandomPairs<TypeParam> expected = start;
      expected.evaluate(passes<TypeParam>("baseline", Arithmetic::portable), variant);
      for (const std::string& set : instruction_sets()) {
        RandomPairs<TypeParam> pairs = start;
        pairs.evaluate(passes<TypeParam>(set, Arithmetic::portable), variant);
        expect_same_bytes(pairs.loads, expected.loads, set);
        expect_same_bytes(pairs.across, expected.across, set);
        for (std::size_t h = 0; h < 6; ++h) expect_same_bytes(pairs.history[h], expected.history[h], set);
      }
    }
}

TYPED_TEST(PassesOf, FusedArithmeticAgreesToRounding) {
  // Units in the last place of the terms, of which 2.2e-16 and 1.2e-7 is one, some ten of them; a dashpot sees what
  // is left of velocities that are up to 100 times as large.
  const double within = std::is_same_v<TypeParam, double> ? 1e-12 : 1e-5;
  for (const LawVariant variant : variants) {
    RandomPairs<TypeParam> expected(6);
    expected.evaluate(passes<TypeParam>("baseline", Arithmetic::portable), variant);
    for (const std::string& set : instruction_sets()) {
      RandomPairs<TypeParam> pairs(6);
      pairs.evaluate(passes<TypeParam>(set, Arithmetic::fused), variant);
      for (std::size_t p = 0; p < pairs.first.size(); ++p) {
        if (pairs.overlap(p) <= 0.0) continue;
        const PairConstants c = pair_constants(Material{}, pairs.first_radius[p], pairs.second_radius[p]);
        const Vector3 force = vector_of(expected.loads[2 * p].force), torque = vector_of(expected.loads[2 * p].torque);
        const double scale = normal_force(c, pairs.overlap(p), 0.0) + force.norm();
        EXPECT_LT((vector_of(pairs.loads[2 * p].force) - force).norm(), within * scale) << set;
        EXPECT_LT((vector_of(pairs.loads[2 * p].torque) - torque).norm(), within * (6e-3 * scale + torque.norm()));
        EXPECT_LT((pairs.spring(p) - expected.spring(p)).norm(), within * (expected.spring(p).norm() + 2e-6)) << set;
        EXPECT_LT((pairs.torque(p) - expected.torque(p)).norm(), within * (expected.torque(p).norm() + 1e-6)) << set;
      }
    }
  }
}

TYPED_TEST(PassesOf, EveryInstructionSetGivesTheSameBitsOfGrains) {
  for (const MotionPart part : {MotionPart::end, MotionPart::begin, MotionPart::end_and_begin}) {
    MovingBodies<TypeParam> expected;
    const Passes<TypeParam> baseline = passes<TypeParam>("baseline", Arithmetic::portable);
    const MotionExtremes extremes = expected.move(baseline, part);
    const double slack = expected.slack(baseline);
    const Moments moments = expected.moments(baseline);
    for (const std::string& set : instruction_sets()) {
      MovingBodies<TypeParam> moving;
      const Passes<TypeParam> here = passes<TypeParam>(set, Arithmetic::portable);
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
  for (const std::string& set : sets) {
    std::printf("instruction set %s\n", set.c_str());
    EXPECT_NE(passes<double>(set, Arithmetic::fused).contacts, passes<double>(set, Arithmetic::portable).contacts);
  }
  for (const char* unknown : {"sse", "", "avx2_fused"})
    try {
      passes<float>(unknown, Arithmetic::portable);
      FAIL() << "there is an instruction set '" << unknown << "'";
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find("baseline"), std::string::npos);
    }
}

}  // namespace
}  // namespace flowslide::native
