// SPDX-License-Identifier: GPL-2.0-or-later
#include "coupling/stress_reading.hpp"

#include <gtest/gtest.h>

#include "sample/failure.hpp"

namespace flowslide {
namespace {

constexpr BasalStress balance{2650.0, 28340.0};
/// The servo ended 156 Pa short in shear and 40 Pa over in normal stress.
constexpr CellStress prepared{28380.0, 2494.0, 0.0, 28000.0, 28000.0};
constexpr CellStress liquefied{0.0, 0.0, 0.0, 0.0, 0.0};
constexpr CellStress halved{14190.0, 1000.0, 0.0, 14000.0, 14000.0};

TEST(StressReading, LeftOutTellsWhatTheSampleBears) {
  const StressReading reading(ResidualTreatment::left_out, balance, prepared);
  EXPECT_EQ(reading.read(prepared).shear, 2494.0);
  EXPECT_EQ(reading.read(prepared).normal, 28380.0);
  EXPECT_EQ(reading.read(liquefied).shear, 0.0);
  EXPECT_EQ(reading.residual().shear, 156.0);
  EXPECT_EQ(reading.residual().normal, -40.0);
}

TEST(StressReading, FadingStartsInBalanceAndLiquefiesToNothing) {
  const StressReading reading(ResidualTreatment::fades, balance, prepared);
  EXPECT_DOUBLE_EQ(reading.read(prepared).shear, balance.shear);
  EXPECT_DOUBLE_EQ(reading.read(prepared).normal, balance.normal);
  EXPECT_DOUBLE_EQ(reading.read(halved).shear, 1078.0);
  EXPECT_DOUBLE_EQ(reading.read(halved).normal, 14170.0);
  EXPECT_EQ(reading.read(liquefied).shear, 0.0);
  EXPECT_EQ(reading.read(liquefied).normal, 0.0);
}

TEST(StressReading, StayingIsThatOfIncrementsAndLeavesStrengthBehind) {
  const StressReading reading(ResidualTreatment::stays, balance, prepared);
  EXPECT_DOUBLE_EQ(reading.read(prepared).shear, balance.shear);
  EXPECT_DOUBLE_EQ(reading.read(liquefied).shear, 156.0);
  EXPECT_DOUBLE_EQ(reading.read(liquefied).normal, -40.0);
}

TEST(StressReading, RefusesASampleOfAnotherSlope) {
  const CellStress isotropic{28340.0, 0.0, 0.0, 28340.0, 28340.0};
  for (const auto treatment : {ResidualTreatment::left_out, ResidualTreatment::fades}) {
    EXPECT_THROW(StressReading(treatment, balance, isotropic), NumericalFailure);
    EXPECT_THROW(StressReading(treatment, balance, liquefied), NumericalFailure);
    EXPECT_THROW(StressReading(treatment, balance, halved), NumericalFailure);
    EXPECT_NO_THROW(StressReading(treatment, {0.0, 28340.0}, isotropic));
  }
  EXPECT_NO_THROW(StressReading(ResidualTreatment::stays, balance, isotropic));
}

}  // namespace
}  // namespace flowslide
