// SPDX-License-Identifier: GPL-2.0-or-later
#include "dem/native/cell_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "pair_search.hpp"

namespace flowslide::native {
namespace {

/// Number of pairs, all checked.
template <typename Real>
std::size_t compare_with_all_pairs(const Assembly& cloud, const std::vector<double>& allowance,
                                   const GrainRange& range) {
  const auto found = CellGrid(cloud.cell, bodies_of<Real>(cloud), allowance).pairs(range);
  const auto expected = every_near_pair(cloud, allowance, range);
  EXPECT_EQ(found.size(), expected.size());
  for (std::size_t k = 0; k < std::min(found.size(), expected.size()); ++k) {
    EXPECT_EQ(found[k].first, expected[k].first);
    EXPECT_EQ(found[k].second, expected[k].second);
    EXPECT_EQ(found[k].image, expected[k].image);
  }
  return expected.size();
}
std::size_t compare_with_all_pairs(const Assembly& cloud, double allowance) {
  return compare_with_all_pairs<double>(cloud, std::vector(cloud.size(), allowance), {0, cloud.size()});
}

TEST(CellGrid, FindsWhatAnAllPairsSearchFinds) {
  std::size_t pairs = 0;
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    // Cells are at least 13.5 mm long, so that reaches of up to 6.7 mm see one image of each grain.
    const Assembly cloud = fuzzed_cloud(seed);
    Dice dice(seed);
    const auto allowance = some_allowances(cloud.size(), dice);
    pairs += compare_with_all_pairs<double>(cloud, allowance, {0, cloud.size()});
    const std::size_t begin = dice.below(cloud.size() + 1), end = begin + dice.below(cloud.size() + 1 - begin);
    compare_with_all_pairs<double>(cloud, allowance, {begin, end});
    compare_with_all_pairs<float>(cloud, allowance, {begin, end});
    ASSERT_FALSE(HasFailure()) << "seed " << seed;
  }
  EXPECT_GT(pairs, 20000u);
}

TEST(CellGrid, FindsThemInALargerCellOfManyBins) {
  for (const bool periodic : {true, false}) {
    const Assembly cloud = clustered_cloud(7, cube(0.06, periodic), {.grains = 400});
    EXPECT_GT(compare_with_all_pairs(cloud, 1e-4), 300u);
    const std::vector<double> allowance(cloud.size(), 1e-4);
    EXPECT_GT(compare_with_all_pairs<double>(cloud, allowance, {64, 192}), 100u);
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
    EXPECT_EQ(compare_with_all_pairs(pair, 5e-5), periodic ? 1u : 0u);
  }
}

TEST(CellGrid, ASparseCellNeedsNoBinPerGrainWidth) {
  Assembly pair;
  pair.cell = cube(1000.0, true);
  pair.resize(2);
  pair.radius = {1e-3, 1e-3};
  pair.position = {Vector3(499.9995, 0.0, 0.0), Vector3(-499.9996, 0.0, 0.0)};
  EXPECT_EQ(compare_with_all_pairs(pair, 5e-5), 1u);
}

TEST(CellGrid, AFastGrainReachesFurtherThanItsNeighbours) {
  Assembly row;
  row.cell = cube(0.1, false);
  row.resize(3);
  row.radius = {1e-3, 1e-3, 1e-3};
  row.position = {Vector3::Zero(), Vector3(2.3e-3, 0.0, 0.0), Vector3(4.6e-3, 0.0, 0.0)};
  const auto pairs = [&](const std::vector<double>& allowance) {
    return compare_with_all_pairs<double>(row, allowance, {0, 3});
  };
  EXPECT_EQ(pairs({1e-4, 1e-4, 1e-4}), 0u);
  EXPECT_EQ(pairs({2.1e-4, 1e-4, 1e-4}), 1u);
  EXPECT_EQ(pairs({1e-4, 2.1e-4, 1e-4}), 2u);
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
