// SPDX-License-Identifier: GPL-2.0-or-later
#include "slope/driving_stress.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace flowslide {
namespace {

constexpr double rounding = 1e-12;  // relative; some ten operations of double precision
constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

/// The message that `validate` throws, or "" if it does not.
std::string complaint(const StressHistory& history) {
  try {
    validate(history);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(StressHistory, WeightAloneNeverChanges) {
  for (const double time : {0.0, 1.0, 1e6}) EXPECT_EQ(stress_change(NoChange{}, time), 0.0);
}

TEST(StressHistory, ConstantRateGoesOnOrIsHeld) {
  // 1e3 kPa/min is 16.667 kPa/s (Fig. 8).
  EXPECT_NEAR(stress_change(ConstantRate{1e6 / 60.0}, 3.0), 50e3, 50e3 * rounding);
  const ConstantRate held{1e3, 2.0};
  EXPECT_EQ(stress_change(held, 1.0), 1e3);
  EXPECT_EQ(stress_change(held, 2.0), 2e3);
  EXPECT_EQ(stress_change(held, 50.0), 2e3);
  EXPECT_EQ(stress_change(ConstantRate{-1e3, 2.0}, 50.0), -2e3);
}

TEST(StressHistory, PulseIsASineThatIsRemoved) {
  const SinePulse pulse{3e3, 2.0};
  EXPECT_EQ(stress_change(pulse, 0.0), 0.0);
  EXPECT_NEAR(stress_change(pulse, 1.0 / 3.0), 1.5e3, 1.5e3 * rounding);  // sin 30 deg
  EXPECT_NEAR(stress_change(pulse, 1.0), 3e3, 3e3 * rounding);
  EXPECT_NEAR(stress_change(pulse, 2.0 - 1e-9), 3e3 * std::acos(-1.0) / 2.0 * 1e-9, 1e-12);
  EXPECT_EQ(stress_change(pulse, 2.0), 0.0);  // exactly, not sin(pi) in doubles
  EXPECT_EQ(stress_change(pulse, 3.0), 0.0);  // where the sine would pull
}

TEST(StressHistory, TableHasStraightLinesBetweenItsPointsAndHoldsItsEnds) {
  const StressTable table{{1.0, 2.0, 4.0}, {100.0, 300.0, -100.0}};
  EXPECT_EQ(stress_change(table, 0.0), 100.0);
  EXPECT_EQ(stress_change(table, 1.0), 100.0);
  EXPECT_DOUBLE_EQ(stress_change(table, 1.25), 150.0);
  EXPECT_EQ(stress_change(table, 2.0), 300.0);
  EXPECT_DOUBLE_EQ(stress_change(table, 3.5), 0.0);
  EXPECT_EQ(stress_change(table, 4.0), -100.0);
  EXPECT_EQ(stress_change(table, 9.0), -100.0);
  EXPECT_EQ(stress_change(StressTable{{5.0}, {7.0}}, 1.0), 7.0);
}

TEST(StressHistory, RefusesWhatIsNoLoading) {
  EXPECT_EQ(complaint(NoChange{}), "");
  EXPECT_EQ(complaint(SinePulse{}), "");
  EXPECT_EQ(complaint(ConstantRate{1.0}), "");  // without end
  EXPECT_EQ(complaint(SinePulse{3e3, 0.0}),
            "slope: duration of the pulse is 0; allowed: finite and > 0 s. Give T, such as 2 s.");
  EXPECT_NE(complaint(SinePulse{3e3, -2.0}).find("-2"), std::string::npos);
  EXPECT_NE(complaint(SinePulse{3e3, infinity}).find("duration"), std::string::npos);
  EXPECT_NE(complaint(SinePulse{nan_value, 2.0}).find("amplitude"), std::string::npos);
  EXPECT_NE(complaint(ConstantRate{infinity}).find("rate of the driving stress"), std::string::npos);
  EXPECT_NE(complaint(ConstantRate{1.0, 0.0}).find("duration of the loading"), std::string::npos);
}

TEST(StressHistory, RefusesATableThatIsEmptyUnsortedOrNotFinite) {
  EXPECT_NE(complaint(StressTable{}).find("number of rows of the loading table is 0; allowed: 1 or more"),
            std::string::npos);
  EXPECT_NE(complaint(StressTable{{0.0, 1.0}, {0.0}}).find("number of stresses"), std::string::npos);
  EXPECT_NE(complaint(StressTable{{0.0, 2.0, 1.0}, {0.0, 0.0, 0.0}}).find("time in row 3 of the loading table is 1"),
            std::string::npos);
  EXPECT_NE(complaint(StressTable{{0.0, 0.0}, {0.0, 1.0}}).find("row 2"), std::string::npos);  // a jump
  EXPECT_NE(complaint(StressTable{{0.0, nan_value}, {0.0, 1.0}}).find("time in row 2"), std::string::npos);
  EXPECT_NE(complaint(StressTable{{0.0, 1.0}, {nan_value, 1.0}}).find("stress in row 1"), std::string::npos);
}

TEST(DrivingStress, StartsAtTheWeightOfTheSlope) {
  const SlopeProperties slope;
  const DrivingStress driving(slope, SinePulse{3e3, 2.0});
  EXPECT_EQ(driving.initial(), initial_shear_stress(slope));
  EXPECT_EQ(driving.at(0.0), initial_shear_stress(slope));
  EXPECT_NEAR(driving.at(1.0), 2650.4933 + 3e3, 1e-4);  // eq. 8 to the digits written
  EXPECT_THROW(DrivingStress(slope, SinePulse{3e3, 0.0}), std::invalid_argument);
  SlopeProperties wrong;
  wrong.angle = -1.0;
  EXPECT_THROW(DrivingStress(wrong, NoChange{}), std::invalid_argument);
}

}  // namespace
}  // namespace flowslide
