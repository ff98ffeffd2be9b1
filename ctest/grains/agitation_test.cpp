// SPDX-License-Identifier: GPL-2.0-or-later
#include "grains/agitation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "grains/packing.hpp"

namespace flowslide {
namespace {

Assembly agitated(double speed, std::uint64_t seed) {
  Assembly packing = lattice_packing({.counts = {10, 10, 11}});
  packing.role[0] = Role::bottom_layer;
  agitate(packing, speed, seed);
  return packing;
}

TEST(Agitation, GivesEachAxisItsSpeedAndNoMomentum) {
  const Assembly moving = agitated(0.5, 1);
  EXPECT_EQ(moving.velocity[0], Vector3::Zero());  // it is glued
  Vector3 momentum = Vector3::Zero(), squares = Vector3::Zero();
  double scale = 0.0;
  for (std::size_t i = 1; i < moving.size(); ++i) {
    const double volume = std::pow(moving.radius[i], 3);
    momentum += volume * moving.velocity[i];
    scale += volume * moving.velocity[i].norm();
    squares += moving.velocity[i].cwiseAbs2();
  }
  EXPECT_LT(momentum.norm(), 1e-12 * scale);
  // The variance of 1099 normal numbers scatters by sqrt(2/1099) = 4.3 %: four of that.
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(squares[axis] / 1099 / 0.25, 1.0, 0.17);
}

TEST(Agitation, IsThatOfItsSeed) {
  EXPECT_EQ(agitated(0.5, 1).velocity, agitated(0.5, 1).velocity);
  EXPECT_NE(agitated(0.5, 1).velocity[7], agitated(0.5, 2).velocity[7]);
  for (const Vector3& velocity : agitated(0.0, 1).velocity) EXPECT_EQ(velocity.norm(), 0.0);
}

TEST(Agitation, RefusesASpeedThatIsNone) {
  for (const double speed : {-0.1, std::nan("")}) EXPECT_THROW(agitated(speed, 1), std::invalid_argument);
}

}  // namespace
}  // namespace flowslide
