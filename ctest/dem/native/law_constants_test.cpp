// SPDX-License-Identifier: GPL-2.0-or-later
#include "dem/native/law_constants.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "grains/material.hpp"
#include "grains/pair_constants.hpp"

namespace flowslide::native {
namespace {

TEST(LawConstants, OfHertzAreThoseOfItsFormulas) {
  const Material m;
  const auto c = law_constants<double>(m, 2e-6);
  const double modulus = m.youngs_modulus / (2.0 * (1.0 - m.poisson_ratio * m.poisson_ratio));
  const double shear = m.youngs_modulus / (4.0 * (2.0 - m.poisson_ratio) * (1.0 + m.poisson_ratio));
  const double log_e = std::log(m.restitution), pi = 3.14159265358979323846;
  const double dashpot = -2.0 * std::sqrt(5.0 / 6.0) * log_e / std::sqrt(log_e * log_e + pi * pi);
  const double rolling = 2.25 * 0.1 * 0.1;
  const auto& normal = c.of<laws::Hertz>();
  EXPECT_DOUBLE_EQ(normal.normal, 4.0 / 3.0 * modulus);
  EXPECT_DOUBLE_EQ(normal.normal_damping, dashpot * std::sqrt(2.0 * modulus));
  EXPECT_DOUBLE_EQ(normal.tangential, 8.0 * shear);
  EXPECT_DOUBLE_EQ(normal.tangential_damping, dashpot * std::sqrt(8.0 * shear));
  EXPECT_EQ(c.of<laws::Sliding>().sliding_friction, 0.5);
  EXPECT_EQ(c.of<laws::Epsd3>().rolling_friction, 0.1);
  EXPECT_DOUBLE_EQ(c.of<laws::Epsd3>().rolling_stiffness, rolling);
  EXPECT_DOUBLE_EQ(c.of<laws::Epsd3>().rolling_damping, 2.0 * 0.13 * std::sqrt(rolling * 4.0 / 3.0 * modulus));
  EXPECT_EQ(c.time_step, 2e-6);
}

TEST(LawConstants, ScaledCapsChangeTheCapsAndStopTheClock) {
  const auto c = with_scaled_caps(law_constants<double>(Material{}, 2e-6), 0.5);
  EXPECT_EQ(c.time_step, 0.0);
  EXPECT_EQ(c.of<laws::Sliding>().sliding_friction, 0.25);
  EXPECT_EQ(c.of<laws::Epsd3>().rolling_friction, 0.05);
  EXPECT_EQ(c.of<laws::Hertz>().normal, law_constants<double>(Material{}, 2e-6).of<laws::Hertz>().normal);
}

TEST(LawConstants, AVariantLeavesOutPartsWithoutFriction) {
  Material m;
  EXPECT_EQ(variant_of(m), LawVariant::sliding_and_rolling);
  m.rolling_friction = 0.0;
  EXPECT_EQ(variant_of(m), LawVariant::sliding);
  m.sliding_friction = 0.0;
  EXPECT_EQ(variant_of(m), LawVariant::frictionless);
}

TEST(LawConstants, TheScaleOfHertzChangesWithTheOverlap) {
  EXPECT_FALSE(has_constant_scale(ContactLaw::hertz));
  EXPECT_EQ(constant_root_scale(ContactLaw::hertz, 1.0, 1.0), 0.0);
}

}  // namespace
}  // namespace flowslide::native
