// SPDX-License-Identifier: GPL-2.0-or-later
#include "dem/native/pair_list.hpp"

#include <gtest/gtest.h>

#include "grains/pair_constants.hpp"
#include "pair_search.hpp"

namespace flowslide::native {
namespace {

void expect_all_pairs(const Assembly& cloud, PairList& list, double skin) {
  const PairView view = list.view(cloud.cell);
  std::size_t p = 0;
  for (std::uint32_t i = 0; i < cloud.size(); ++i)
    for (const Neighbour& neighbour : every_later_neighbour(cloud, i, skin)) {
      if (in_one_layer(cloud, i, neighbour.index)) continue;
      ASSERT_LT(p, list.pairs());
      EXPECT_EQ(view.first[p], i);
      EXPECT_EQ(view.second[p], neighbour.index);
      EXPECT_EQ(view.image[p], neighbour.image);
      ++p;
    }
  EXPECT_EQ(p, list.pairs());
  // Whole tiles, filled with a pair of nobody.
  EXPECT_EQ(view.count % tile_size, 0u);
  EXPECT_LT(view.count - p, static_cast<std::size_t>(tile_size));
  for (; p < view.count; ++p) {
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

TEST(PairList, LosesNoPairAndNoHistoryOfTenThousandRandomClouds) {
  std::size_t contacts = 0, open = 0;
  for (std::uint64_t seed = 0; seed < 10000; ++seed) {
    const Assembly cloud = fuzzed_cloud(seed);
    const auto bodies = bodies_of(cloud);
    const double skin = Dice(seed).between(0.0, 7e-4);
    PairList list;
    list.build(cloud.cell, bodies, cloud.role, skin);
    expect_all_pairs(cloud, list, skin);
    list.set_histories(cloud.contacts);
    expect_same_histories(list.histories(bodies), listed(cloud));
    // A rebuild with another skin drops open pairs and adds others; what touches keeps its history.
    const double other = Dice(seed + 1).between(0.0, 7e-4);
    list.build(cloud.cell, bodies, cloud.role, other);
    expect_all_pairs(cloud, list, other);
    expect_same_histories(list.histories(bodies), listed(cloud));
    ASSERT_FALSE(HasFailure()) << "seed " << seed;
    contacts += listed(cloud).size();
    open += list.pairs() - listed(cloud).size();
  }
  RecordProperty("contacts", std::to_string(contacts));
  EXPECT_GT(contacts, 50000u);
  EXPECT_GT(open, 20000u);
}

TEST(PairList, ForgetsWhatLeavesTheListAndWhatIsNotGiven) {
  const Assembly cloud = clustered_cloud(1, cube(0.04, true));
  const auto bodies = bodies_of(cloud);
  PairList list;
  list.build(cloud.cell, bodies, cloud.role, 1e-4);
  list.set_histories(cloud.contacts);
  auto apart = bodies;
  for (std::size_t i = 0; i < cloud.size(); ++i) apart[i].radius *= 0.5;
  list.build(cloud.cell, apart, cloud.role, 1e-4);
  ASSERT_EQ(list.pairs(), 0u);
  list.build(cloud.cell, bodies, cloud.role, 1e-4);
  for (const ContactHistory& contact : list.histories(bodies)) {
    EXPECT_EQ(contact.tangential_spring.norm(), 0.0);
    EXPECT_EQ(contact.rolling_torque.norm(), 0.0);
  }
  auto half = cloud.contacts;
  for (std::size_t c = half.size(); c-- > 0;)
    if (c % 2 == 0) half.erase(half.begin() + static_cast<std::ptrdiff_t>(c));
  list.set_histories(cloud.contacts);
  list.set_histories(half);
  std::size_t loaded = 0;
  for (const ContactHistory& contact : list.histories(bodies)) loaded += contact.rolling_torque.norm() > 0.0;
  EXPECT_EQ(loaded, half.size());
}

TEST(PairList, ConstantsAreThoseOfThePairs) {
  Assembly cloud = clustered_cloud(2, cube(0.04, true));
  const Material m;
  auto bodies = bodies_of(cloud);
  for (std::size_t i = 0; i < cloud.size(); ++i) bodies[i].mass = sphere_mass(cloud.radius[i], m);
  PairList list;
  list.build(cloud.cell, bodies, cloud.role, 1e-4);
  const PairView view = list.view(cloud.cell);
  ASSERT_GT(list.pairs(), 50u);
  for (std::size_t p = 0; p < list.pairs(); ++p) {
    const double first = cloud.radius[view.first[p]], second = cloud.radius[view.second[p]];
    const PairConstants expected = pair_constants(m, first, second);
    EXPECT_EQ(view.first_radius[p], first);
    EXPECT_EQ(view.second_radius[p], second);
    EXPECT_DOUBLE_EQ(view.effective_radius[p], expected.effective_radius);
    EXPECT_DOUBLE_EQ(view.root_effective_mass[p], std::sqrt(expected.effective_mass));
    EXPECT_DOUBLE_EQ(view.root_rolling_inertia[p], std::sqrt(expected.rolling_inertia));
  }
}

TEST(PairList, SeparationIsThatOfTheNearestImageAndFollowsThePeriods) {
  const Assembly cloud = clustered_cloud(3, cube(0.04, true));
  const auto bodies = bodies_of(cloud);
  PairList list;
  list.build(cloud.cell, bodies, cloud.role, 1e-4);
  Cell shorter = cloud.cell;
  shorter.upper.x() -= 1e-3;
  bool through_a_face = false;
  for (std::size_t p = 0; p < list.pairs(); ++p) {
    const PairView view = list.view(cloud.cell);
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
