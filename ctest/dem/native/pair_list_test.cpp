// SPDX-License-Identifier: GPL-2.0-or-later
#include "dem/native/pair_list.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <set>

#include "grains/pair_constants.hpp"
#include "pair_search.hpp"

namespace flowslide::native {
namespace {

template <typename Real>
void expect_all_pairs(const Assembly& cloud, PairList<Real>& list, const std::vector<double>& allowance,
                      const GrainRange& range) {
  const PairView<Real> view = list.view(cloud.cell);
  std::size_t p = 0;
  for (const NearPair& pair : every_near_pair(cloud, allowance, range)) {
    if (in_one_layer(cloud, pair.first, pair.second)) continue;
    ASSERT_LT(p, list.pairs());
    EXPECT_EQ(view.first[p], pair.first);
    EXPECT_EQ(view.second[p], pair.second);
    EXPECT_EQ(view.image[p], pair.image);
    ++p;
  }
  EXPECT_EQ(p, list.pairs());
  // Whole tiles, filled with a pair of nobody.
  EXPECT_EQ(view.end % tile_size, 0u);
  EXPECT_LT(view.end - p, static_cast<std::size_t>(tile_size));
  for (; p < view.end; ++p) {
    EXPECT_EQ(view.first[p], cloud.size());
    EXPECT_EQ(view.second[p], cloud.size() + 1);
  }
}

void expect_same_histories(const std::vector<ContactHistory>& found, const std::vector<ContactHistory>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t c = 0; c < found.size(); ++c) {
    EXPECT_EQ(found[c].first, expected[c].first);
    EXPECT_EQ(found[c].second, expected[c].second);
    EXPECT_EQ(found[c].tangential_spring, expected[c].tangential_spring);
    EXPECT_EQ(found[c].rolling_torque, expected[c].rolling_torque);
  }
}

/// Histories of the pairs that the list holds: not of pairs of one layer.
std::vector<ContactHistory> listed(const Assembly& cloud) {
  std::vector<ContactHistory> histories;
  for (const ContactHistory& contact : cloud.contacts)
    if (!in_one_layer(cloud, contact.first, contact.second)) histories.push_back(contact);
  return histories;
}

template <typename Real>
std::vector<ContactHistory> histories(const PairList<Real>& list, const std::vector<Body<Real>>& bodies) {
  std::vector<ContactHistory> contacts;
  list.add_histories(bodies, contacts);
  return contacts;
}

/// Searches and builds with the same allowances.
template <typename Real>
void make(PairList<Real>& list, const Assembly& cloud, const std::vector<Body<Real>>& bodies,
          const std::vector<double>& allowance) {
  list.search(cloud.cell, bodies, cloud.role, allowance, ContactLaw::hertz);
  list.build(cloud.cell, bodies, allowance);
}

TEST(PairList, LosesNoPairAndNoHistoryOfTenThousandRandomClouds) {
  std::size_t contacts = 0, open = 0;
  for (std::uint64_t seed = 0; seed < 10000; ++seed) {
    const Assembly cloud = fuzzed_cloud(seed);
    const GrainRange all{0, cloud.size()};
    const auto bodies = bodies_of(cloud);
    Dice dice(seed);
    const auto allowance = some_allowances(cloud.size(), dice), other = some_allowances(cloud.size(), dice);
    std::vector<double> wide;
    for (std::size_t i = 0; i < cloud.size(); ++i) wide.push_back(allowance[i] + other[i]);
    PairList<double> list(all);
    list.search(cloud.cell, bodies, cloud.role, wide, ContactLaw::hertz);
    list.build(cloud.cell, bodies, allowance);
    expect_all_pairs(cloud, list, allowance, all);
    list.set_histories(cloud.contacts);
    expect_same_histories(histories(list, bodies), listed(cloud));
    // A rebuild with other allowances drops open pairs and adds others; what touches keeps its history.
    list.build(cloud.cell, bodies, other);
    expect_all_pairs(cloud, list, other, all);
    expect_same_histories(histories(list, bodies), listed(cloud));
    ASSERT_FALSE(HasFailure()) << "seed " << seed;
    contacts += listed(cloud).size();
    open += list.pairs() - listed(cloud).size();
  }
  std::printf("%zu contacts, %zu open pairs\n", contacts, open);
  EXPECT_GT(contacts, 50000u);
  EXPECT_GT(open, 10000u);
}

/// Stored, as g++ 12 leaves a conversion there and back out when it makes vectors of it.
double in_float(double x) {
  volatile float rounded = static_cast<float>(x);
  return rounded;
}

/// The grains that `range` does not own, in pairs that it lists.
std::vector<std::uint32_t> foreign_grains(const Assembly& cloud, const std::vector<double>& allowance,
                                          const GrainRange& range) {
  std::set<std::uint32_t> grains;
  for (const NearPair& pair : every_near_pair(cloud, allowance, range))
    for (const std::uint32_t i : {pair.first, pair.second})
      if (!range.owns(i) && !in_one_layer(cloud, pair.first, pair.second)) grains.insert(i);
  return {grains.begin(), grains.end()};
}

TEST(PairList, SharesHoldWhatTouchesTheirGrainsAndEachContactIsSavedOnce) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const Assembly cloud = fuzzed_cloud(seed);
    Dice dice(seed);
    const auto allowance = some_allowances(cloud.size(), dice);
    const std::size_t cut = dice.below(cloud.size() + 1);
    std::vector<ContactHistory> saved;
    for (const GrainRange range : {GrainRange{0, cut}, GrainRange{cut, cloud.size()}}) {
      const auto bodies = bodies_of<float>(cloud);
      PairList<float> list(range);
      make(list, cloud, bodies, allowance);
      expect_all_pairs(cloud, list, allowance, range);
      EXPECT_EQ(list.foreign(), foreign_grains(cloud, allowance, range));
      list.set_histories(cloud.contacts);
      list.add_histories(bodies, saved);
    }
    auto expected = listed(cloud);
    for (ContactHistory& contact : expected)
      for (int axis = 0; axis < 3; ++axis) {
        contact.tangential_spring[axis] = in_float(contact.tangential_spring[axis]);
        contact.rolling_torque[axis] = in_float(contact.rolling_torque[axis]);
      }
    expect_same_histories(saved, expected);
    ASSERT_FALSE(HasFailure()) << "seed " << seed;
  }
}

TEST(PairList, ForgetsWhatLeavesTheListAndWhatIsNotGiven) {
  const Assembly cloud = clustered_cloud(1, cube(0.04, true));
  const auto bodies = bodies_of(cloud);
  const std::vector<double> allowance(cloud.size(), 5e-5);
  PairList<double> list({0, cloud.size()});
  make(list, cloud, bodies, allowance);
  list.set_histories(cloud.contacts);
  auto apart = bodies;
  for (std::size_t i = 0; i < cloud.size(); ++i) apart[i].radius *= 0.5;
  make(list, cloud, apart, allowance);
  ASSERT_EQ(list.pairs(), 0u);
  make(list, cloud, bodies, allowance);
  for (const ContactHistory& contact : histories(list, bodies)) {
    EXPECT_EQ(contact.tangential_spring.norm(), 0.0);
    EXPECT_EQ(contact.rolling_torque.norm(), 0.0);
  }
  auto half = cloud.contacts;
  for (std::size_t c = half.size(); c-- > 0;)
    if (c % 2 == 0) half.erase(half.begin() + static_cast<std::ptrdiff_t>(c));
  list.set_histories(cloud.contacts);
  list.set_histories(half);
  std::size_t loaded = 0;
  for (const ContactHistory& contact : histories(list, bodies)) loaded += contact.rolling_torque.norm() > 0.0;
  EXPECT_EQ(loaded, half.size());
}

TEST(PairList, FollowsAGrainThatIsFolded) {
  const Assembly cloud = clustered_cloud(4, cube(0.04, true));
  auto bodies = bodies_of(cloud);
  PairList<double> list({0, cloud.size()});
  make(list, cloud, bodies, std::vector<double>(cloud.size(), 5e-5));
  list.view(cloud.cell);
  std::vector<Vector3> before;
  for (std::size_t p = 0; p < list.pairs(); ++p) before.push_back(list.separation(p, bodies));
  for (std::uint32_t grain = 0; grain < cloud.size(); grain += 7)
    for (int axis = 0; axis < 3; ++axis) {
      const int periods = bodies[grain].position[axis] < 0.0 ? 1 : -1;
      bodies[grain].position[axis] += periods * 0.04;
      list.carry(grain, axis, periods);
    }
  // Coordinates of 0.06 m round to 7e-18 m.
  for (std::size_t p = 0; p < list.pairs(); ++p) EXPECT_LT((list.separation(p, bodies) - before[p]).norm(), 3e-17);
  // So do the pairs that the next list is built from.
  list.build(cloud.cell, bodies, std::vector<double>(cloud.size(), 4.99e-5));
  ASSERT_GT(list.pairs(), before.size() / 2);
  for (std::size_t p = 0; p < list.pairs(); ++p) EXPECT_LT(list.separation(p, bodies).norm(), 0.0101);
}

template <typename Real>
void expect_constants(double tolerance) {
  const Assembly cloud = clustered_cloud(2, cube(0.04, true));
  PairList<Real> list({0, cloud.size()});
  make(list, cloud, bodies_of<Real>(cloud), std::vector<double>(cloud.size(), 5e-5));
  const PairView<Real> view = list.view(cloud.cell);
  ASSERT_GT(list.pairs(), 50u);
  for (std::size_t p = 0; p < list.pairs(); ++p) {
    const double first = cloud.radius[view.first[p]], second = cloud.radius[view.second[p]];
    const PairConstants expected = pair_constants(Material{}, first, second);
    EXPECT_EQ(view.first_radius[p], first);
    EXPECT_EQ(view.second_radius[p], second);
    EXPECT_NEAR(view.effective_radius[p] / expected.effective_radius, 1.0, tolerance);
    EXPECT_NEAR(view.root_effective_mass[p] / std::sqrt(expected.effective_mass), 1.0, tolerance);
    EXPECT_NEAR(view.root_rolling_inertia[p] / std::sqrt(expected.rolling_inertia), 1.0, tolerance);
  }
}

TEST(PairList, ConstantsAreThoseOfThePairs) {
  expect_constants<double>(4 * 0x1p-53);  // a few rounded operations
  expect_constants<float>(2 * 0x1p-24);   // of rounded masses, rounded once
}

TEST(PairList, SeparationIsThatOfTheNearestImageAndFollowsThePeriods) {
  const Assembly cloud = clustered_cloud(3, cube(0.04, true));
  const auto bodies = bodies_of(cloud);
  PairList<double> list({0, cloud.size()});
  make(list, cloud, bodies, std::vector<double>(cloud.size(), 5e-5));
  Cell shorter = cloud.cell;
  shorter.upper.x() -= 1e-3;
  bool through_a_face = false;
  for (std::size_t p = 0; p < list.pairs(); ++p) {
    const PairView<double> view = list.view(cloud.cell);
    const Vector3 plain = cloud.position[view.first[p]] - cloud.position[view.second[p]];
    // One rounding of a coordinate, 4e-18 m.
    EXPECT_LT((list.separation(p, bodies) - cloud.cell.nearest_image(plain)).norm(), 2e-17);
    const Vector3 before = list.separation(p, bodies);
    list.view(shorter);
    const double shift = std::abs(list.separation(p, bodies).x() - before.x());
    const bool outside = std::abs(plain.x()) > 0.02;
    EXPECT_NEAR(shift, outside ? 1e-3 : 0.0, 1e-17);
    through_a_face = through_a_face || outside;
  }
  EXPECT_TRUE(through_a_face);
}

}  // namespace
}  // namespace flowslide::native
