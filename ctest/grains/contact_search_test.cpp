// SPDX-License-Identifier: GPL-2.0-or-later
#include "grains/contact_search.hpp"

#include <gtest/gtest.h>

#include <random>

#include "random_assembly.hpp"

namespace flowslide {
namespace {

using testing::random_cloud;

std::vector<TouchingPair> brute_force(const Assembly& a) {
  std::vector<TouchingPair> pairs;
  for (std::uint32_t i = 0; i < a.size(); ++i)
    for (std::uint32_t j = i + 1; j < a.size(); ++j)
      if (a.cell.nearest_image(a.position[i] - a.position[j]).norm() < a.radius[i] + a.radius[j])
        pairs.push_back({i, j});
  return pairs;
}

TEST(TouchingPairs, EqualBruteForceInCellsOfManyShapes) {
  // Largest diameter 7.5 mm: one, two, three and many boxes along the axes.
  const std::vector<Vector3> cells{{0.08, 0.07, 0.09}, {0.016, 0.05, 0.023}, {0.02, 0.017, 0.16}, {0.0226, 0.03, 0.04}};
  std::size_t found = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed)
    for (const Vector3& lengths : cells)
      for (int mask = 0; mask < 8; ++mask) {
        Assembly cloud = random_cloud(seed, 150, lengths, {(mask & 1) != 0, (mask & 2) != 0, (mask & 4) != 0});
        if ((mask & 5) == 5 && seed % 2 == 0) cloud.cell.shear_offset = 0.3 * lengths.x();
        const auto expected = brute_force(cloud);
        EXPECT_EQ(touching_pairs(cloud), expected) << "seed " << seed << ", lengths " << lengths.transpose();
        found += expected.size();
      }
  EXPECT_GT(found, 1000u);
}

TEST(TouchingPairs, OfGrainsOutsideTheCell) {
  for (const bool periodic : {false, true}) {
    Assembly cloud = random_cloud(7, 200, Vector3(0.05, 0.05, 0.05), {periodic, periodic, false});
    std::mt19937_64 generator(8);
    for (Vector3& x : cloud.position) x += testing::uniform_vector(generator, 0.04);
    EXPECT_EQ(touching_pairs(cloud), brute_force(cloud));
  }
}

TEST(TouchingPairs, OfAFewGrainsInAHugeCell) {
  Assembly pair = random_cloud(1, 2, Vector3(1e3, 1e3, 1e3), {false, false, true});
  pair.position[0] = pair.cell.lower + Vector3(500.0, 500.0, 0.001);
  pair.position[1] = pair.cell.lower + Vector3(500.0, 500.0, 999.999);
  EXPECT_EQ(touching_pairs(pair), (std::vector<TouchingPair>{{0, 1}}));
}

TEST(TouchingPairs, WithoutACellOrGrains) {
  EXPECT_TRUE(touching_pairs(Assembly{}).empty());
  Assembly pair;  // a cell of no size
  pair.resize(2);
  pair.radius = {1.0, 1.0};
  pair.position[1].x() = 1.5;
  EXPECT_EQ(touching_pairs(pair).size(), 1u);
}

TEST(TouchingPairs, SurfacesThatJustMeetDoNotTouch) {
  Assembly pair;
  pair.resize(2);
  pair.radius = {1.0, 0.5};
  pair.position[1].z() = 1.5;
  EXPECT_TRUE(touching_pairs(pair).empty());
}

TEST(TouchingPairs, LeaveOutThoseOfOneLayer) {
  Assembly cloud = random_cloud(3, 300, Vector3(0.04, 0.04, 0.03), {true, true, false});
  testing::glue_layers(cloud, 0.012);
  std::vector<TouchingPair> expected;
  for (const TouchingPair& pair : brute_force(cloud)) {
    const Role first = cloud.role[pair.first], second = cloud.role[pair.second];
    const bool both_glued = first != Role::mobile && second != Role::mobile;
    if (!both_glued || first != second) expected.push_back(pair);
  }
  EXPECT_LT(expected.size(), brute_force(cloud).size());
  EXPECT_EQ(touching_pairs(cloud), expected);
  EXPECT_EQ(touching_pairs(cloud, SearchScope::all_pairs), brute_force(cloud));
}

}  // namespace
}  // namespace flowslide
