// SPDX-License-Identifier: GPL-2.0-or-later
#include "grains/pair_constants.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "grains/material.hpp"

namespace flowslide {
namespace {

Material simple_material() {
  Material material;
  material.density = 3.0 / (4.0 * std::numbers::pi);  // a sphere of radius R weighs R^3
  material.youngs_modulus = 15.0;
  material.poisson_ratio = 0.5;
  material.restitution = std::exp(-std::numbers::pi);
  return material;
}

TEST(PairConstants, OfTwoSpheres) {
  const PairConstants pair = pair_constants(simple_material(), 1.0, 2.0);
  EXPECT_EQ(pair.radius_first, 1.0);
  EXPECT_EQ(pair.radius_second, 2.0);
  EXPECT_DOUBLE_EQ(pair.effective_radius, 2.0 / 3.0);
  EXPECT_DOUBLE_EQ(pair.effective_mass, 8.0 / 9.0);
  EXPECT_DOUBLE_EQ(pair.effective_modulus, 10.0);                  // 15 / (2 * 3/4)
  EXPECT_DOUBLE_EQ(pair.effective_shear_modulus, 15.0 / 9.0);      // 15 / (4 * 3/2 * 3/2)
  EXPECT_DOUBLE_EQ(pair.damping, -std::numbers::sqrt2 / 2.0);      // -pi / sqrt(2 pi^2)
  EXPECT_DOUBLE_EQ(pair.rolling_inertia, 1.4 * 1.0 * 32.0 / 33.0);  // J = R^5
}

TEST(PairConstants, OfASphereAtAPlane) {
  const PairConstants plane = plane_constants(simple_material(), 2.0);
  EXPECT_EQ(plane.effective_radius, 2.0);
  EXPECT_DOUBLE_EQ(plane.effective_mass, 8.0);
  EXPECT_DOUBLE_EQ(plane.effective_modulus, 10.0);
  EXPECT_DOUBLE_EQ(plane.rolling_inertia, 1.4 * 32.0);
}

TEST(PairConstants, PerfectRestitutionHasNoDamping) {
  Material material;
  material.restitution = 1.0;
  EXPECT_EQ(pair_constants(material, 1.0, 1.0).damping, 0.0);
}

TEST(Sphere, MassAndInertia) {
  EXPECT_DOUBLE_EQ(sphere_mass(2.0, simple_material()), 8.0);
  EXPECT_DOUBLE_EQ(sphere_inertia(2.0, simple_material()), 12.8);
}

}  // namespace
}  // namespace flowslide
