// SPDX-License-Identifier: GPL-2.0-or-later
#include "dem/native/cell_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "pair_search.hpp"

namespace flowslide::native {
namespace {

/// Number of pairs, all checked.
std::size_t compare_with_all_pairs(const Assembly& cloud, double skin) {
  const auto bodies = bodies_of(cloud);
  const CellGrid grid(cloud.cell, bodies, cloud.size(), skin);
  std::vector<Neighbour> found;
  std::size_t pairs = 0;
  for (std::uint32_t i = 0; i < cloud.size(); ++i) {
    grid.later_neighbours(i, found);
    const auto expected = every_later_neighbour(cloud, i, skin);
    EXPECT_EQ(found.size(), expected.size()) << "grain " << i;
    for (std::size_t k = 0; k < std::min(found.size(), expected.size()); ++k) {
      EXPECT_EQ(found[k].index, expected[k].index);
      EXPECT_EQ(found[k].image, expected[k].image);
    }
    pairs += expected.size();
  }
  return pairs;
}

TEST(CellGrid, FindsWhatAnAllPairsSearchFinds) {
  std::size_t pairs = 0;
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    // Cells are at least 13.5 mm long, so that reaches of up to 6.7 mm see one image of each grain.
    pairs += compare_with_all_pairs(fuzzed_cloud(seed), Dice(seed).between(0.0, 7e-4));
    ASSERT_FALSE(HasFailure()) << "seed " << seed;
  }
  EXPECT_GT(pairs, 20000u);
}

TEST(CellGrid, FindsThemInALargerCellOfManyBins) {
  for (const bool periodic : {true, false}) {
    CloudShape shape;
    shape.grains = 400;
    EXPECT_GT(compare_with_all_pairs(clustered_cloud(7, cube(0.06, periodic), shape), 2e-4), 300u);
  }
}

TEST(CellGrid, TakesGrainsAtTheFacesOfTheCell) {
  for (const bool periodic : {true, false}) {
    Assembly pair;
    pair.cell = cube(0.03, periodic);
    pair.resize(2);
    pair.radius = {2e-3, 2e-3};
    // Folding a coordinate just below the lower face rounds to the upper one.
    pair.position = {Vector3(0.015, 0.015, -0.015), Vector3(-0.0145, 0.0145, 0.0145)};
    EXPECT_EQ(compare_with_all_pairs(pair, 1e-4), periodic ? 1u : 0u);
  }
}

TEST(CellGrid, ASparseCellNeedsNoBinPerGrainWidth) {
  Assembly pair;
  pair.cell = cube(1000.0, true);
  pair.resize(2);
  pair.radius = {1e-3, 1e-3};
  pair.position = {Vector3(499.9995, 0.0, 0.0), Vector3(-499.9996, 0.0, 0.0)};
  EXPECT_EQ(compare_with_all_pairs(pair, 1e-4), 1u);
}

TEST(CellGrid, ImagesHaveDifferentNumbers) {
  std::set<int> numbers;
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z) numbers.insert(image_of(x, y, z));
  EXPECT_EQ(numbers.size(), 27u);
  EXPECT_EQ(*numbers.rbegin(), 26);
}

}  // namespace
}  // namespace flowslide::native
