// SPDX-License-Identifier: GPL-2.0-or-later
#include "grains/material.hpp"

#include <gtest/gtest.h>

namespace flowslide {
namespace {

TEST(Material, DefaultsAreTable1) {
  const Material material;
  EXPECT_EQ(material.density, 2650.0);
  EXPECT_EQ(material.youngs_modulus, 2e9);
  EXPECT_EQ(material.poisson_ratio, 0.25);
  EXPECT_EQ(material.restitution, 0.8);
  EXPECT_EQ(material.sliding_friction, 0.5);
  EXPECT_EQ(material.rolling_friction, 0.1);
}

TEST(Material, ShearModulus) { EXPECT_DOUBLE_EQ(Material{}.shear_modulus(), 0.8e9); }  // 2 GPa / (2 * 1.25)

}  // namespace
}  // namespace flowslide
