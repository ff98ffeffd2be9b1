// SPDX-License-Identifier: GPL-2.0-or-later
#include "sample/packing_health.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "dem/make_engine.hpp"
#include "grains/random.hpp"
#include "grains/void_ratio_profile.hpp"
#include "sample/preparation.hpp"
#include "support/touching_lattice.hpp"

namespace flowslide {
namespace {

/// The recipe of a lattice of touching grains; its axes have walls.
SampleRecipe recipe_of(int side, int layers) {
  SampleRecipe recipe;
  recipe.packing.counts = {side, side, layers};
  return recipe;
}

TEST(PackingHealth, OfALatticeShowsItsOrderAndItsContacts) {
  const Assembly lattice = touching_lattice(10, 11);
  const PackingHealth health = packing_health(lattice, recipe_of(10, 11));
  for (const AxisHealth& axis : health.axes) {
    EXPECT_NEAR(axis.lattice_order, 1.0, 1e-4);  // sites are off by up to 0.1 %
    EXPECT_NEAR(axis.middle_order.value, 1.0, 1e-4);
    EXPECT_NEAR(axis.largest_order, 1.0, 1e-4);
    EXPECT_LT(axis.spread, 0.01);
  }
  EXPECT_EQ(health.axes[0].slices, 6);
  EXPECT_EQ(health.axes[2].slices, 7);
  EXPECT_NEAR(health.network.mechanical_coordination_number, 6.0, 0.1);
  EXPECT_NE(unevenness(health).find("order of the lattice along"), std::string::npos) << unevenness(health);
}

TEST(PackingHealth, HalvesBearWhatTheWholeDoes) {
  const Assembly lattice = touching_lattice(6, 9);
  const PackingHealth health = packing_health(lattice, recipe_of(6, 9));
  EXPECT_GT(health.lower_half.normal, 1e4);
  // Disorder of 0.1 % against overlaps of 0.2 %: 36 columns each average it.
  EXPECT_NEAR(health.upper_half.normal / health.lower_half.normal, 1.0, 0.2);
}

TEST(PackingHealth, OfIndependentPositionsHasNoOrderAndASeamIsSeen) {
  Assembly grains = touching_lattice(10, 11);
  Generator generator(4);
  for (Vector3& position : grains.position)
    for (int axis = 0; axis < 3; ++axis) position[axis] = grains.cell.upper[axis] * uniform(generator);
  const SampleRecipe recipe = recipe_of(10, 11);
  const PackingHealth random = packing_health(grains, recipe);
  for (const AxisHealth& axis : random.axes) {
    EXPECT_LT(axis.middle_order.value, order_of_random_positions(axis.middle_order.grains, 4.0));
    EXPECT_LT(axis.lattice_order, 3.0 / std::sqrt(1100.0));
  }
  // A third of the solid of the middle third goes: z from 0.36 to 0.64.
  Assembly seamed = touching_lattice(10, 11);
  const double before = packing_health(seamed, recipe).axes[2].seam;
  for (std::size_t i = 400; i < 700; ++i) seamed.radius[i] *= std::cbrt(2.0 / 3.0);
  const PackingHealth health = packing_health(seamed, recipe);
  // Seven inner slices: the middle three have 3/2 (1 + e) - 1.
  EXPECT_NEAR(health.axes[2].seam - before, 0.5 * (1.0 + void_ratio_profile(touching_lattice(10, 11), 2, 11)[5]), 0.1);
}

TEST(Unevenness, NamesWhatExceedsItsLimitMostWithValueAndLimit) {
  PackingHealth health;
  for (AxisHealth& axis : health.axes) {
    axis.slices = 9;
    axis.counting = 0.03;
    axis.spread = 0.03;
    axis.largest_deviation = 0.08;
    axis.seam = 0.01;
    axis.middle_order = {0.03, 660};
  }
  EXPECT_EQ(unevenness(health), "");
  health.axes[1].largest_deviation = 0.121;  // 4 counting deviations are 0.12
  EXPECT_NE(unevenness(health).find("slice across y is off the mean by 0.121, where 0.12 is allowed"),
            std::string::npos)
      << unevenness(health);
  health.axes[0].seam = -0.2;  // 4 * 0.03 * sqrt(1/3 + 1/6)
  EXPECT_NE(unevenness(health).find("seam across x: void ratios of its middle and its outer part differ by 0.2, where "
                                    "0.0849 is allowed"),
            std::string::npos)
      << unevenness(health);
  health.axes[0].seam = 0.0;
  health.axes[2].spread = 0.09;  // 0.03 (1 + 4/sqrt(16))
  EXPECT_NE(unevenness(health).find("slices across z spread by 0.09, where 0.06 is allowed"), std::string::npos)
      << unevenness(health);
  health.axes[2].middle_order.value = 0.4;  // 2.74/sqrt(660)
  EXPECT_NE(unevenness(health).find("order of the lattice along z: in the middle of the cell it is 0.4, where 0.107 is "
                                    "allowed"),
            std::string::npos)
      << unevenness(health);
}

TEST(Unevenness, IsNotToldOfSamplesTooSmallToTell) { EXPECT_EQ(unevenness({}), ""); }

/// A small sample of the recipe of which the scatter is stated, mixed or from its lattice.
PreparedSample prepared(SampleRecipe& recipe, bool mixed) {
  recipe.compaction_rate = 2.0;
  recipe.stress_tolerance = 5e-3;
  if (mixed) {
    recipe.mixing_velocity = 0.5;
    recipe.drag_reference = DragReference::uniform_compression;
  }
  return prepare_sample(*make_engine("native", ""), recipe);
}

TEST(PackingHealth, AMixedSampleIsEvenAndOneOfALatticeIsNot) {
  SampleRecipe even = recipe_of(5, 6), lattice = recipe_of(5, 6);
  const Assembly mixed = prepared(even, true).assembly, old = prepared(lattice, false).assembly;
  EXPECT_EQ(unevenness(packing_health(mixed, even)), "");
  const std::string found = unevenness(packing_health(old, lattice));
  EXPECT_NE(found.find("order of the lattice"), std::string::npos) << found;
}

TEST(PackingHealth, SlicesOfAHomogeneousSampleScatterAsCountingDoes) {
  SampleRecipe recipe = recipe_of(6, 7);
  recipe.periodic_height = true;
  const PackingHealth health = packing_health(prepared(recipe, true).assembly, recipe);
  double squares = 0.0, expected = 0.0;
  for (const AxisHealth& axis : health.axes) {
    squares += axis.spread * axis.spread / 3.0;
    expected += axis.counting * axis.counting / 3.0;
    EXPECT_GE(axis.slices, 6);  // no walls
  }
  // 16 degrees of freedom: the root scatters by 1/sqrt(32) = 18 %; three of that.
  EXPECT_NEAR(std::sqrt(squares / expected), 1.0, 0.54);
}

}  // namespace
}  // namespace flowslide
