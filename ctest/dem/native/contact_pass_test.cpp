// SPDX-License-Identifier: GPL-2.0-or-later
#include "dem/native/contact_pass.hpp"

#include <gtest/gtest.h>

#include "random_pairs.hpp"

namespace flowslide::native {
namespace {

/// How far the pass may be from the law of the grains, of the force and of the history before.
template <typename Real>
constexpr double tolerance = 0.0;
/// Some ten rounded operations.
template <>
constexpr double tolerance<double> = 1e-13;
/// The same in float, whose unit is 1.2e-7; a dashpot sees differences of velocities that are rounded as well.
template <>
constexpr double tolerance<float> = 2e-6;

template <typename Real>
class ContactPassOf : public testing::Test {};
using Precisions = testing::Types<double, float>;
TYPED_TEST_SUITE(ContactPassOf, Precisions);

template <typename Real>
Passes<Real> widest() {
  return passes<Real>(instruction_sets().back());
}

TYPED_TEST(ContactPassOf, EveryLawIsThatOfTheGrains) {
  constexpr double within = tolerance<TypeParam>;
  std::size_t sliding = 0, rolling = 0, sticking = 0;
  for (const Material& m : materials()) {
    const LawVariant variant = variant_of(m);
    RandomPairs<TypeParam> pairs(3, m);
    pairs.image_velocity = TypeParam(0.75);
    const RandomPairs<TypeParam> before = pairs;
    pairs.evaluate(widest<TypeParam>());
    for (std::size_t p = 0; p < pairs.first.size(); ++p) {
      if (pairs.overlap(p) <= 0.0) continue;
      const double radius = pairs.first_radius[p];
      const ContactForce law = before.law(p);
      const Load<TypeParam>&first = pairs.loads[2 * p], &second = pairs.loads[2 * p + 1];
      // The scale is that of the terms, as spring and dashpot may cancel.
      const PairConstants c = pair_constants(m, radius, pairs.second_radius[p]);
      const double force = normal_force(m, c, pairs.overlap(p), 0.0) + law.on_first.norm();
      EXPECT_LT((vector_of(first.force) - law.on_first).norm(), within * force);
      EXPECT_EQ(vector_of(first.force), -vector_of(second.force));
      const double torque = force * (radius + pairs.second_radius[p]) + law.rolling_torque.norm();
      EXPECT_LT((vector_of(first.torque) - law.torque_on_first).norm(), within * torque);
      EXPECT_LT((vector_of(second.torque) - law.torque_on_second).norm(), within * torque);
      if (variant != LawVariant::frictionless) {
        // Springs advance by v dt of up to 2e-6 m, which is rounded as well.
        EXPECT_LT((pairs.spring(p) - law.tangential_spring).norm(), within * (before.spring(p).norm() + 2e-6));
        ++(law.sliding ? sliding : sticking);
      }
      if (variant != LawVariant::sliding_and_rolling) continue;
      EXPECT_LT((pairs.torque(p) - law.rolling_torque).norm(), within * (before.torque(p).norm() + 1e-6));
      rolling += law.rolling;
    }
  }
  EXPECT_GT(sliding, 20u);  // the example has all cases in it
  EXPECT_GT(sticking, 20u);
  EXPECT_GT(rolling, 20u);
}

TYPED_TEST(ContactPassOf, OpenPairsAddExactZerosAndForgetTheirHistories) {
  for (const Material& m : materials()) {
    const LawVariant variant = variant_of(m);
    RandomPairs<TypeParam> pairs(4, m);
    pairs.loads.assign(pairs.bodies.size(), {{1, 2, 3}, 0, {4, 5, 6}, 0});
    pairs.evaluate(widest<TypeParam>());
    std::size_t open = 0;
    for (std::size_t p = 0; p < pairs.first.size(); ++p) {
      if (pairs.overlap(p) > 0.0) continue;
      ++open;
      for (const std::size_t i : {2 * p, 2 * p + 1}) {
        EXPECT_EQ(vector_of(pairs.loads[i].force), Vector3(1, 2, 3));
        EXPECT_EQ(vector_of(pairs.loads[i].torque), Vector3(4, 5, 6));
      }
      if (variant == LawVariant::frictionless) continue;
      EXPECT_EQ(pairs.spring(p), Vector3(0, 0, 0));
      if (variant == LawVariant::sliding) continue;
      EXPECT_EQ(pairs.torque(p), Vector3(0, 0, 0));
    }
    EXPECT_GT(open, 20u);
  }
}

TYPED_TEST(ContactPassOf, WhatPairsDoAcrossFacesIsSummedByTheBlockOfTheirFirstGrain) {
  RandomPairs<TypeParam> pairs(6);
  const RandomPairs<TypeParam> before = pairs;
  const AcrossFaces start{7.0, 8.0, 9.0, 10.0, 11.0};
  pairs.across.assign(pairs.across.size(), start);
  pairs.evaluate(widest<TypeParam>());
  std::vector<AcrossFaces> sum(pairs.across.size(), start);
  std::size_t across = 0;
  for (std::size_t p = 0; p < pairs.first.size(); ++p)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double* shift = pairs.shift[pairs.image[p]];
      AcrossFaces& block = sum[2 * p / block_size];
      if (axis < 2) block[axis] += shift[axis] * pairs.loads[2 * p].force[axis];
      block[2 + axis] += shift[2] * pairs.loads[2 * p].force[axis];
      across += shift[axis] != 0.0 && pairs.overlap(p) > 0.0;
    }
  // Sums of ten or so terms of 0.2 m and up to some 100 N, rounded in double.
  for (std::size_t block = 0; block < sum.size(); ++block)
    for (std::size_t k = 0; k < sum[block].size(); ++k) EXPECT_NEAR(pairs.across[block][k], sum[block][k], 1e-12);
  EXPECT_GT(across, 20u);
  // Without a place for it, everything else is the same.
  RandomPairs<TypeParam> plain = before;
  widest<TypeParam>().contacts(law_constants<TypeParam>(plain.material, pass_step),
                               plain.view(), plain.bodies.data(), plain.loads.data(), nullptr);
  for (std::size_t i = 0; i < pairs.loads.size(); ++i)
    EXPECT_EQ(vector_of(plain.loads[i].force), vector_of(pairs.loads[i].force));
}

TYPED_TEST(ContactPassOf, FetchingGrainsAheadChangesNoBit) {
  const RandomPairs<TypeParam> before(7);
  for (const std::string& set : instruction_sets()) {
    RandomPairs<TypeParam> plain = before, fetched = before;
    plain.evaluate(passes<TypeParam>(set));
    PairView<TypeParam> view = fetched.view();
    view.fetch_end = view.end;  // four tiles: two of them are fetched ahead
    passes<TypeParam>(set).contacts(law_constants<TypeParam>(fetched.material, pass_step), view, fetched.bodies.data(),
                                    fetched.loads.data(), nullptr);
    for (std::size_t p = 0; p < plain.first.size(); ++p) {
      EXPECT_EQ(vector_of(fetched.loads[2 * p].force), vector_of(plain.loads[2 * p].force));
      EXPECT_EQ(vector_of(fetched.loads[2 * p + 1].torque), vector_of(plain.loads[2 * p + 1].torque));
      EXPECT_EQ(fetched.spring(p), plain.spring(p));
    }
  }
}

}  // namespace
}  // namespace flowslide::native
