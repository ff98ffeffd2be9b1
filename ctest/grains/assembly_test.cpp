// SPDX-License-Identifier: GPL-2.0-or-later
#include "grains/assembly.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace flowslide {
namespace {

Cell example_cell() {
  Cell cell;
  cell.lower = Vector3(1.0, 2.0, 3.0);
  cell.upper = Vector3(3.0, 6.0, 11.0);
  return cell;
}

TEST(Cell, Measures) {
  const Cell cell = example_cell();
  EXPECT_EQ(cell.lengths(), Vector3(2.0, 4.0, 8.0));
  EXPECT_EQ(cell.volume(), 64.0);
  EXPECT_EQ(cell.area(), 8.0);
  EXPECT_EQ(cell.height(), 8.0);
}

TEST(Cell, NearestImageWrapsPeriodicAxesOnly) {
  Cell cell = example_cell();
  cell.periodic = {true, false, true};
  EXPECT_EQ(cell.nearest_image(Vector3(1.5, 3.5, -7.0)), Vector3(-0.5, 3.5, 1.0));
  EXPECT_EQ(cell.nearest_image(Vector3(0.75, -3.5, 3.0)), Vector3(0.75, -3.5, 3.0));
  EXPECT_EQ(cell.nearest_image(Vector3(-8.5, 0.0, 17.0)), Vector3(-0.5, 0.0, 1.0));
}

TEST(Cell, ImagesAboveAShearedCellAreFurtherAndFaster) {
  Cell cell = example_cell();  // 2 m x 4 m x 8 m
  cell.periodic = {true, false, true};
  cell.shear_offset = 0.75;
  cell.shear_velocity = 3.0;
  EXPECT_EQ(cell.nearest_image(Vector3(0.5, 3.5, 7.0)), Vector3(-0.25, 3.5, -1.0));
  EXPECT_EQ(cell.nearest_image(Vector3(0.5, 3.5, -7.0)), Vector3(-0.75, 3.5, 1.0));  // 1.25 is beyond half a period
  EXPECT_EQ(cell.nearest_image(Vector3(0.5, 3.5, 1.0)), Vector3(0.5, 3.5, 1.0));
  EXPECT_EQ(cell.nearest_image_velocity(Vector3(0.5, 3.5, 7.0)), Vector3(3.0, 0.0, 0.0));
  EXPECT_EQ(cell.nearest_image_velocity(Vector3(0.5, 3.5, -15.0)), Vector3(-6.0, 0.0, 0.0));
  EXPECT_EQ(cell.nearest_image_velocity(Vector3(0.5, 3.5, 1.0)), Vector3(0.0, 0.0, 0.0));
}

TEST(Assembly, ResizeAddsMobileGrainsAtRest) {
  Assembly assembly;
  assembly.resize(2);
  assembly.role[1] = Role::top_layer;
  assembly.resize(3);
  EXPECT_EQ(assembly.size(), 3u);
  EXPECT_EQ(assembly.role[1], Role::top_layer);
  EXPECT_EQ(assembly.role[2], Role::mobile);
  for (const auto* array :
       {&assembly.position, &assembly.velocity, &assembly.spin, &assembly.force, &assembly.torque}) {
    ASSERT_EQ(array->size(), 3u);
    EXPECT_EQ(array->at(2), Vector3::Zero());
  }
}

TEST(Assembly, SumsOverGrains) {
  Assembly assembly;
  assembly.resize(2);
  assembly.radius = {1.0, 2.0};
  // 4/3 pi (1 + 8)
  EXPECT_DOUBLE_EQ(assembly.solid_volume(), 12.0 * std::numbers::pi);
  EXPECT_EQ(assembly.mean_diameter(), 3.0);
  EXPECT_EQ(assembly.smallest_radius(), 1.0);
}

}  // namespace
}  // namespace flowslide
