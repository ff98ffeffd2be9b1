// SPDX-License-Identifier: GPL-2.0-or-later
#include "dem/uniform_flow.hpp"

#include <gtest/gtest.h>

namespace flowslide {
namespace {

constexpr double rounding = 1e-16;  // m/s, of speeds below 1 m/s

Cell cell_of(bool x, bool y, bool z) {
  Cell cell;
  cell.lower = {0.01, -0.02, 0.005};
  cell.upper = {0.05, 0.03, 0.045};
  cell.periodic = {x, y, z};
  return cell;
}

const BoundaryMotion motion{{0.1, -0.2, 0.05}, {0.4, 0.3, -0.15}, 2.0, -3.0};

TEST(UniformFlow, MovesWithThePlanesOfRigidAxes) {
  const Cell cell = cell_of(false, false, false);
  const UniformFlow flow = uniform_flow(cell, motion);
  const Vector3 lower = flow.at(cell.lower), upper = flow.at(cell.upper);
  EXPECT_NEAR(lower.x(), 0.5 * 2.0 * 0.04, rounding);  // the planes of a side of the length L move at -/+ rate L/2
  EXPECT_NEAR(upper.x(), -0.5 * 2.0 * 0.04, rounding);
  EXPECT_NEAR(lower.y(), -0.5 * 3.0 * 0.05, rounding);
  EXPECT_NEAR(upper.y(), 0.5 * 3.0 * 0.05, rounding);
  EXPECT_NEAR(lower.z(), 0.05, rounding);
  EXPECT_NEAR(upper.z(), -0.15, rounding);
  const Vector3 middle = flow.at(0.5 * (cell.lower + cell.upper));
  EXPECT_LT((middle - Vector3(0.0, 0.0, -0.05)).norm(), rounding);
  EXPECT_LT((flow.at({0.02, 0.01, 0.03}) - 0.5 * (flow.at({0.02, 0.0, 0.02}) + flow.at({0.02, 0.02, 0.04}))).norm(),
            rounding);  // it is affine
}

TEST(UniformFlow, GluedLayersShearIt) {
  const Cell cell = cell_of(true, true, false);
  const UniformFlow flow = uniform_flow(cell, motion);
  // Along periodic axes it has the velocity of the layers wherever it is: their compression enters no velocity.
  for (const double x : {0.01, 0.05}) {
    EXPECT_LT((flow.at({x, x, cell.lower.z()}) - motion.bottom_velocity).norm(), rounding);
    EXPECT_LT((flow.at({x, x, cell.upper.z()}) - motion.top_velocity).norm(), rounding);
  }
}

TEST(UniformFlow, ShearsAPeriodicHeightAboutItsMiddle) {
  Cell cell = cell_of(true, true, true);
  cell.shear_velocity = 0.3;
  const UniformFlow flow = uniform_flow(cell, motion);
  EXPECT_LT((flow.at(cell.lower) - Vector3(-0.15, 0.0, 0.0)).norm(), rounding);
  EXPECT_LT((flow.at(cell.upper) - Vector3(0.15, 0.0, 0.0)).norm(), rounding);
}

TEST(UniformFlow, DragRelativeToRestHasNone) {
  const Cell cell = cell_of(false, true, false);
  EXPECT_EQ(drag_flow(DragReference::rest, cell, motion).at(cell.upper), Vector3::Zero());
  EXPECT_EQ(drag_flow(DragReference::uniform_compression, cell, motion).at(cell.upper),
            uniform_flow(cell, motion).at(cell.upper));
}

}  // namespace
}  // namespace flowslide
