// SPDX-License-Identifier: GPL-2.0-or-later
#include "grains/kinetic_stress.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "random_assembly.hpp"

namespace flowslide {
namespace {

/// Weighs R^3 at radius R.
Material light_material() {
  Material material;
  material.density = 0.75 / 3.14159265358979323846;
  return material;
}

/// Four grains of 1 kg at the corners of a square at z = 1 in a cell of 24 m^3.
Assembly square() {
  Assembly assembly;
  assembly.resize(4);
  assembly.cell.upper = Vector3(3.0, 2.0, 4.0);
  assembly.radius.assign(4, 1.0);
  for (int i = 0; i < 4; ++i) assembly.position[i] = Vector3(i % 2, i / 2, 1.0);
  return assembly;
}

TEST(KineticStress, OfKnownFluctuations) {
  Assembly assembly = square();
  const Vector3 mean(10.0, -20.0, 30.0), swing(1.0, 2.0, 0.0);
  for (int i = 0; i < 4; ++i) assembly.velocity[i] = mean + (i < 2 ? 1.0 : -1.0) * swing;
  Matrix3 expected;
  expected << 4.0, 8.0, 0.0, 8.0, 16.0, 0.0, 0.0, 0.0, 0.0;
  EXPECT_LE((kinetic_stress(assembly, light_material()) - expected / 24.0).norm(), 1e-13);
}

TEST(KineticStress, MeanMotionIsThatOfTheMass) {
  Assembly assembly = square();
  assembly.resize(2);
  assembly.radius = {1.0, 2.0};
  assembly.velocity[0].x() = 9.0;
  // Masses 1 and 8, mean 1: 1 * 8^2 + 8 * 1^2 in 24 m^3.
  EXPECT_NEAR(kinetic_stress(assembly, light_material())(0, 0), 3.0, 1e-13);
}

TEST(KineticStress, OfPureShearIsZero) {
  Assembly cloud = testing::random_cloud(1, 500, Vector3(0.04, 0.04, 0.04), {true, true, false});
  for (std::size_t i = 0; i < cloud.size(); ++i)
    cloud.velocity[i] = Vector3(5.0 + 100.0 * cloud.position[i].z(), 2.0 * cloud.position[i].z(), -1.0);
  // m v^2 / V with 500 grains of 0.3 g, 10 m/s and 64 cm^3 is of the order of 2e5 Pa; rounding of velocities squared.
  EXPECT_LE(kinetic_stress(cloud, Material{}, 1).norm(), 1e-20 * 2e5);
  EXPECT_LE(kinetic_stress(cloud, Material{}, 10).norm(), 1e-20 * 2e5);
}

TEST(KineticStress, LocalisedShearNeedsSublayers) {
  Assembly cloud = testing::random_cloud(2, 500, Vector3(0.04, 0.04, 0.04), {true, true, false});
  const double middle = cloud.cell.lower.z() + 0.02;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    cloud.velocity[i] = Vector3(cloud.position[i].z() > middle ? 1.0 : 0.0, 0.0, 0.0);
  EXPECT_GT(kinetic_stress(cloud, Material{}, 1)(0, 0), 1.0);
  EXPECT_LE(kinetic_stress(cloud, Material{}, 2).norm(), 1e-20 * 1e3);
}

TEST(KineticStress, LeavesOutGluedGrains) {
  Assembly cloud = testing::random_cloud(3, 300, Vector3(0.03, 0.03, 0.03), {true, true, false});
  testing::glue_layers(cloud, 0.005);
  const Matrix3 before = kinetic_stress(cloud, Material{});
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (cloud.role[i] != Role::mobile) cloud.velocity[i] = Vector3(1e3, 0.0, 0.0);
  EXPECT_GT(before.norm(), 0.0);
  EXPECT_EQ(kinetic_stress(cloud, Material{}), before);
}

TEST(KineticStress, RefusesNoSublayers) {
  EXPECT_THROW(kinetic_stress(square(), Material{}, 0), std::invalid_argument);
}

}  // namespace
}  // namespace flowslide
