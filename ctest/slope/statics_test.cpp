// SPDX-License-Identifier: GPL-2.0-or-later
#include "slope/statics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

namespace flowslide::statics_test {
namespace {

constexpr double rounding = 1e-14;  // relative; some ten operations of double precision

TEST(Statics, DefaultsAreTable2AtFiveDegrees) {
  const SlopeProperties slope;
  // 2000 * 0.2 + 1500 * 1.8
  EXPECT_NEAR(mass_per_area(slope), 3100.0, 3100.0 * rounding);
  // 3100 * 9.81 * sin 5 deg, and [(2000 - 1000) * 0.2 + 1500 * 1.8] * 9.81 * cos 5 deg, with
  // sin 5 deg = 0.0871557427, cos 5 deg = 0.9961946981: 2650.4933 Pa and 28340.7430 Pa. Tolerance: the digits written.
  EXPECT_NEAR(initial_shear_stress(slope), 2650.4933, 5e-5);
  EXPECT_NEAR(initial_normal_stress(slope), 28340.7430, 5e-5);
}

TEST(Statics, GivesTheRoundedStressesOfThePaper) {
  const SlopeProperties slope;
  // 2.650 kPa and 28.34 kPa as printed; tolerance: half a unit of the last digit.
  EXPECT_NEAR(initial_shear_stress(slope), 2650.0, 0.5);
  EXPECT_NEAR(initial_normal_stress(slope), 28340.0, 5.0);
}

TEST(Statics, WaterTableAboveTheLiquefiableLayer) {
  SlopeProperties slope;
  slope.saturated_density = 1900.0;
  slope.dry_density = 1600.0;
  slope.thickness = 5.0;
  slope.water_table = 1.5;
  slope.liquefiable_thickness = 0.5;
  slope.angle = std::numbers::pi / 6.0;
  slope.gravity = 10.0;
  // m = 1900 * 1.5 + 1600 * 3.5 = 8450; tau_0 = 84500 / 2; sigma_0 = (900 * 1.5 + 5600) * 10 * sqrt(3)/2.
  EXPECT_NEAR(mass_per_area(slope), 8450.0, 8450.0 * rounding);
  EXPECT_NEAR(initial_shear_stress(slope), 42250.0, 42250.0 * rounding);
  EXPECT_NEAR(initial_normal_stress(slope), 34750.0 * std::sqrt(3.0), 60188.0 * rounding);
}

TEST(Statics, LevelGroundHasNoShearAndDrySlopeNoBuoyancy) {
  SlopeProperties slope;
  slope.angle = 0.0;
  EXPECT_EQ(initial_shear_stress(slope), 0.0);
  slope.water_table = 0.0;
  // 1500 * 2 * 9.81
  EXPECT_NEAR(initial_normal_stress(slope), 29430.0, 29430.0 * rounding);
}

TEST(Statics, LiquefiableThicknessDoesNotEnterTheStatics) {
  SlopeProperties slope;
  const double before = initial_normal_stress(slope);
  slope.liquefiable_thickness = 1.0;
  EXPECT_EQ(initial_normal_stress(slope), before);
}

TEST(Statics, UnitWeightOfWater) { EXPECT_DOUBLE_EQ(SlopeProperties{}.unit_weight_of_water(), 9810.0); }

/// The message that `validate` throws, or "" if it does not.
std::string complaint(const SlopeProperties& slope) {
  try {
    validate(slope);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

void expect_refused(double SlopeProperties::*property, double value, const std::string& name) {
  SlopeProperties slope;
  slope.*property = value;
  EXPECT_NE(complaint(slope).find(name), std::string::npos) << name << " = " << value << ": " << complaint(slope);
  EXPECT_NE(complaint(slope).find("allowed"), std::string::npos);
}

TEST(Statics, RefusesPropertiesOutOfRange) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expect_refused(&SlopeProperties::saturated_density, -1.0, "saturated density");
  expect_refused(&SlopeProperties::saturated_density, 1000.0, "saturated density");
  expect_refused(&SlopeProperties::dry_density, 0.0, "dry density");
  expect_refused(&SlopeProperties::dry_density, 2001.0, "at most the saturated density 2000 kg/m^3");
  expect_refused(&SlopeProperties::water_density, nan, "water density");
  expect_refused(&SlopeProperties::gravity, 0.0, "gravity");
  expect_refused(&SlopeProperties::thickness, std::numeric_limits<double>::infinity(), "thickness");
  expect_refused(&SlopeProperties::liquefiable_thickness, 2.1, "liquefiable thickness");
  expect_refused(&SlopeProperties::water_table, -0.1, "water table");
  expect_refused(&SlopeProperties::water_table, 2.1, "water table");
  expect_refused(&SlopeProperties::angle, 5.0, "angle");
  expect_refused(&SlopeProperties::angle, nan, "angle");
  expect_refused(&SlopeProperties::hydraulic_conductivity, -1e-5, "hydraulic conductivity");
}

TEST(Statics, ComplaintStatesValueAndMend) {
  SlopeProperties slope;
  slope.angle = 5.0;
  EXPECT_EQ(complaint(slope), "slope: angle is 5; allowed: [0, pi/2) rad. Give the angle in radians; 5 degrees is "
                              "0.0873 rad.");
  EXPECT_THROW(mass_per_area(slope), std::invalid_argument);
  EXPECT_THROW(initial_shear_stress(slope), std::invalid_argument);
  EXPECT_THROW(initial_normal_stress(slope), std::invalid_argument);
}

TEST(Statics, AcceptsTheEdgesOfTheRanges) {
  SlopeProperties slope;
  slope.liquefiable_thickness = slope.thickness;
  slope.water_table = slope.thickness;
  slope.angle = 0.0;
  EXPECT_EQ(complaint(slope), "");
}

}  // namespace
}  // namespace flowslide::statics_test
