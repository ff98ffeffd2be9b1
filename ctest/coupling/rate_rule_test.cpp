// SPDX-License-Identifier: GPL-2.0-or-later
#include "coupling/rate_rule.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "grains/measures.hpp"

namespace flowslide {
namespace {

TEST(RateRule, GlobalRateIsThatOfTheSlope) {
  EXPECT_EQ(rate_asked(GlobalRate{}, 3.7, 28e3, 1.0), 3.7);
  EXPECT_EQ(rate_asked(GlobalRate{}, 0.0, 28e3, 1.0), 0.0);
}

TEST(RateRule, ConstantStrainRateKnowsNeitherSlopeNorPressure) {
  for (const double pressure : {-10.0, 0.0, 28e3})
    EXPECT_EQ(rate_asked(ConstantStrainRate{0.06}, 5.0, pressure, 1.0), 0.06);
  EXPECT_EQ(rate_asked(ConstantStrainRate{0.06}, 0.0, 28e3, 1.0), 0.06);
}

TEST(RateRule, ConstantInertialNumberFollowsThePressure) {
  const ConstantInertialNumber rule{1e-4, 0.0, {6e-3, 2650.0}};
  // 0.06 1/s is I = 1.1e-4 at 28 kPa (paper, sec. 2.2.1), to the two digits printed.
  EXPECT_NEAR(rate_asked(rule, 5.0, 28e3, 1.0), 0.06 / 1.1, 0.05 * 0.06);
  for (const double pressure : {1.0, 1e3, 28.34e3})
    EXPECT_NEAR(inertial_number(rate_asked(rule, 5.0, pressure, 1.0), 6e-3, 2650.0, pressure), 1e-4, 1e-16);
}

TEST(RateRule, ConstantInertialNumberHasAFloorWhenThePressureIsGone) {
  const ConstantInertialNumber rule{1e-4, 0.5, {}};
  for (const double pressure : {0.0, -10.0, 1e-3}) EXPECT_EQ(rate_asked(rule, 5.0, pressure, 1.0), 0.5) << pressure;
  EXPECT_EQ(rate_asked(ConstantInertialNumber{1e-4, 0.0, {}}, 5.0, 0.0, 1.0), 0.0);
  EXPECT_GT(rate_asked(rule, 0.0, 1e9, 1.0), 0.5);
}

TEST(RateRule, TheFloorGrowsWithTheSquareOfTheStrain) {
  const ConstantInertialNumber rule{1e-4, 0.5, {}, 0.01};
  for (const double strain : {0.001, 0.004, 0.008, -0.008})
    EXPECT_DOUBLE_EQ(rate_asked(rule, 5.0, 0.0, strain), 0.5 * strain * strain / 1e-4);
  for (const double strain : {0.01, 3.0, -0.01}) EXPECT_EQ(rate_asked(rule, 5.0, 28e3, strain), 0.5);
  // Before the peak it is that of I.
  EXPECT_EQ(rate_asked(rule, 5.0, 28e3, 0.002), rate_asked(ConstantInertialNumber{1e-4, 0.0, {}}, 5.0, 28e3, 0.002));
}

TEST(RateRule, AtLeastQuasiStaticIsTheFasterOfTheTwo) {
  const GlobalRateAtLeastQuasiStatic rule{1e-4, {}};
  const double quasi_static = rate_asked(ConstantInertialNumber{1e-4, 0.0, {}}, 0.0, 28e3, 1.0);
  EXPECT_EQ(rate_asked(rule, 0.5 * quasi_static, 28e3, 1.0), quasi_static);
  EXPECT_EQ(rate_asked(rule, 2.0 * quasi_static, 28e3, 1.0), 2.0 * quasi_static);
  EXPECT_EQ(rate_asked(rule, 3.0, 0.0, 1.0), 3.0);
}

TEST(RateRule, RefusesValuesOutOfRange) {
  EXPECT_NO_THROW(validate(RateRule{GlobalRate{}}));
  EXPECT_NO_THROW(validate(RateRule{ConstantInertialNumber{}}));
  EXPECT_THROW(validate(RateRule{ConstantStrainRate{0.0}}), std::invalid_argument);
  EXPECT_THROW(validate(RateRule{ConstantStrainRate{std::nan("")}}), std::invalid_argument);
  EXPECT_THROW(validate(RateRule{ConstantInertialNumber{0.0, 0.5, {}}}), std::invalid_argument);
  EXPECT_THROW(validate(RateRule{ConstantInertialNumber{1e-4, -0.5, {}}}), std::invalid_argument);
  EXPECT_THROW(validate(RateRule{ConstantInertialNumber{1e-4, 0.5, {}, -0.01}}), std::invalid_argument);
  EXPECT_THROW(validate(RateRule{ConstantInertialNumber{1e-4, 0.5, {0.0, 2650.0}}}), std::invalid_argument);
  EXPECT_THROW(validate(RateRule{GlobalRateAtLeastQuasiStatic{1e-4, {6e-3, -1.0}}}), std::invalid_argument);
  EXPECT_THROW(validate(RateRule{GlobalRateAtLeastQuasiStatic{std::nan(""), {}}}), std::invalid_argument);
}

TEST(RateRule, KeepsItsInertialNumberForOtherGrains) {
  const GrainScale grains{3e-3, 2000.0};
  const auto rate = [&](const RateRule& rule) { return rate_asked(for_grains(rule, grains, 28e3), 1e-9, 28e3, 1.0); };
  const double expected = shear_rate_for(1e-4, 3e-3, 2000.0, 28e3);
  EXPECT_EQ(rate(ConstantStrainRate{0.06, 1e-4}), expected);
  EXPECT_EQ(rate(ConstantInertialNumber{1e-4, 0.0, {6e-3, 2650.0}}), expected);
  EXPECT_EQ(rate(GlobalRateAtLeastQuasiStatic{1e-4, {6e-3, 2650.0}}), expected);
  EXPECT_EQ(rate(ConstantStrainRate{0.06}), 0.06);  // chosen as such
  EXPECT_EQ(rate(GlobalRate{}), 1e-9);
}

}  // namespace
}  // namespace flowslide
