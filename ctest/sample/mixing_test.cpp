// SPDX-License-Identifier: GPL-2.0-or-later
#include "sample/mixing.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "grains/random.hpp"

namespace flowslide {
namespace {

TEST(LatticeMemory, IsThereOnALatticeAndForgottenByIndependentPositions) {
  LatticePacking packing{.counts = {10, 10, 11}};
  Assembly grains = lattice_packing(packing);
  const LatticeMemory lattice = lattice_memory(grains, packing);
  EXPECT_FALSE(lattice.forgotten());
  EXPECT_NE(lattice.text().find("along "), std::string::npos);
  for (const MiddleOrder& along : lattice.order) EXPECT_GT(along.value, 0.98);
  Generator generator(1);
  for (Vector3& position : grains.position)
    for (int axis = 0; axis < 3; ++axis) position[axis] = grains.cell.upper[axis] * uniform(generator);
  EXPECT_TRUE(lattice_memory(grains, packing).forgotten());
}

TEST(LatticeMemory, OneAxisIsEnoughToRemember) {
  LatticePacking packing{.counts = {10, 10, 11}};
  Assembly grains = lattice_packing(packing);
  Generator generator(1);
  for (Vector3& position : grains.position)
    for (const int axis : {0, 2}) position[axis] = grains.cell.upper[axis] * uniform(generator);
  const LatticeMemory memory = lattice_memory(grains, packing);
  EXPECT_FALSE(memory.forgotten());
  EXPECT_NE(memory.text().find("along y"), std::string::npos) << memory.text();
}

TEST(Mixing, LooksAfterTheWayFromSiteToSite) {
  SampleRecipe recipe;
  recipe.mixing_velocity = 0.5;
  recipe.time_step = 1e-5;
  EXPECT_EQ(steps_between_checks(recipe), 1650);  // 8.25 mm at 0.5 m/s
  recipe.mixing_velocity = 1e-9;
  EXPECT_EQ(steps_between_checks(recipe), recipe.most_steps);
}

TEST(Mixing, RefusesImpactsThatTheTimeStepDoesNotResolveOrTheLawDoesNotHold) {
  SampleRecipe recipe;
  recipe.mixing_velocity = 0.5;
  EXPECT_NO_THROW(validate_impacts(recipe));
  recipe.time_step = 4e-5;
  EXPECT_THROW(validate_impacts(recipe), std::invalid_argument);
  recipe.mixing_velocity = 0.0;  // no grains collide
  EXPECT_NO_THROW(validate_impacts(recipe));
  recipe.time_step = 1e-7;
  recipe.mixing_velocity = 30.0;
  EXPECT_THROW(validate_impacts(recipe), std::invalid_argument);
}

}  // namespace
}  // namespace flowslide
