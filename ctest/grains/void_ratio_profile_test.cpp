// SPDX-License-Identifier: GPL-2.0-or-later
#include "grains/void_ratio_profile.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "cubic_lattice.hpp"
#include "grains/measures.hpp"
#include "random_assembly.hpp"

namespace flowslide {
namespace {

/// Solid volume of all slices, m^3.
double solid_of(const Assembly& assembly, int axis, int slices) {
  double solid = 0.0;
  for (const double void_ratio : void_ratio_profile(assembly, axis, slices))
    solid += assembly.cell.volume() / slices / (1.0 + void_ratio);
  return solid;
}

TEST(VoidRatioProfile, SlicesHoldTheWholeVolumeOfTheSpheresImagesIncluded) {
  const Assembly cloud = testing::random_cloud(3, 500, {0.05, 0.06, 0.07}, {true, true, true});
  for (int axis = 0; axis < 3; ++axis)
    for (const int slices : {1, 4, 13})
      EXPECT_NEAR(solid_of(cloud, axis, slices), cloud.solid_volume(), 1e-12 * cloud.solid_volume()) << axis << slices;
}

TEST(VoidRatioProfile, WhatLiesBeyondARigidPlaneIsNotInTheCell) {
  Assembly one;
  one.resize(1);
  one.radius[0] = 1.0;
  one.position[0] = Vector3(2.0, 2.0, 0.5);  // half a radius above the bottom
  one.cell.upper = Vector3(4.0, 4.0, 2.0);
  const double above = 4.0 / 3.0 * std::numbers::pi - volume_below(1.0, -0.5);
  EXPECT_NEAR(void_ratio_profile(one, 2, 1).front(), 32.0 / above - 1.0, 1e-12);
}

TEST(VoidRatioProfile, OfASphereCutThroughItsCentreHasHalfInEach) {
  Assembly one;
  one.resize(1);
  one.radius[0] = 1.0;
  one.position[0] = Vector3(1.5, 0.25, 3.0);
  one.cell.upper = Vector3(3.0, 3.0, 6.0);
  one.cell.periodic = {true, true, true};
  const double half = 2.0 / 3.0 * std::numbers::pi;
  for (const double void_ratio : void_ratio_profile(one, 2, 2)) EXPECT_NEAR(void_ratio, 27.0 / half - 1.0, 1e-12);
  for (const double void_ratio : void_ratio_profile(one, 0, 2)) EXPECT_NEAR(void_ratio, 27.0 / half - 1.0, 1e-12);
  // Along y it pokes out below by three quarters of a radius, and in at the top.
  const double below = 4.0 / 3.0 * std::numbers::pi - volume_below(1.0, -0.25);
  EXPECT_NEAR(void_ratio_profile(one, 1, 2)[0], 27.0 / below - 1.0, 1e-12);
}

TEST(VoidRatioProfile, OfALatticeIsThatOfItsLayers) {
  const Assembly lattice = testing::cubic_lattice(6, 1.25, false);
  EXPECT_EQ(slices_of_a_diameter(lattice, 2), 8);  // 7.5 diameters
  for (const double void_ratio : void_ratio_profile(lattice, 2, 6))
    EXPECT_NEAR(void_ratio, void_ratio_of_bulk(lattice, 0), 1e-12);
  // A seam: the third layer is gone but for one grain.
  Assembly seamed = lattice;
  for (std::size_t i = 72; i < 107; ++i) seamed.radius[i] = 1e-3;
  EXPECT_GT(void_ratio_profile(seamed, 2, 6)[2], 30.0 * void_ratio_profile(seamed, 2, 6)[1]);
}

TEST(WithoutWallLayers, LeavesOutTwoSlicesAtEachEndOrAsManyAsLeaveOne) {
  const auto left = [](std::vector<double> slices) { return without_wall_layers(slices); };
  EXPECT_EQ(left({1, 2, 3, 4, 5, 6, 7}), (std::vector<double>{3, 4, 5}));
  EXPECT_EQ(left({1, 2, 3, 4, 5}), (std::vector<double>{3}));
  EXPECT_EQ(left({1, 2, 3, 4}), (std::vector<double>{2, 3}));
  EXPECT_EQ(left({1, 2}), (std::vector<double>{1, 2}));
  EXPECT_EQ(left({}), std::vector<double>{});
}

TEST(VoidRatioProfile, RefusesNoSlicesAndEmptyOnes) {
  const Assembly lattice = testing::cubic_lattice(3, 4.0, false);
  EXPECT_THROW(void_ratio_profile(lattice, 0, 0), std::invalid_argument);
  EXPECT_THROW(void_ratio_profile(lattice, 0, 12), std::invalid_argument);
}

}  // namespace
}  // namespace flowslide
