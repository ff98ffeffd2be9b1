// SPDX-License-Identifier: GPL-2.0-or-later
#include "sample/servo.hpp"

#include <gtest/gtest.h>

namespace flowslide {
namespace {

const Cell cell{Vector3::Zero(), {0.06, 0.06, 0.08}, {true, true, false}};

TEST(Servo, CompressesWhatIsTooSlackAndReleasesWhatIsTooTight) {
  const ServoTarget target{1000.0, 100.0, 0.1};
  const BoundaryMotion motion = servo_motion(target, cell, {500.0, 90.0, 0.0, 1100.0, 1000.0});
  EXPECT_DOUBLE_EQ(motion.top_velocity.z(), -0.1 * 0.5 * 0.08);
  EXPECT_DOUBLE_EQ(motion.bottom_velocity.z(), 0.0);
  EXPECT_DOUBLE_EQ(motion.compression_rate_x, -0.1 * 0.1);
  EXPECT_DOUBLE_EQ(motion.compression_rate_y, 0.0);
  EXPECT_GT(motion.top_velocity.x(), 0.0);  // too little shear stress: the top moves further downslope
}

TEST(Servo, NeverExceedsItsRate) {
  const ServoTarget target{1000.0, 100.0, 0.1};
  const BoundaryMotion motion = servo_motion(target, cell, {1e6, 1e6, 0.0, 1e6, -1e6});
  EXPECT_DOUBLE_EQ(motion.compression_rate_x, -0.1);
  EXPECT_DOUBLE_EQ(motion.compression_rate_y, 0.1);
  EXPECT_DOUBLE_EQ(motion.top_velocity.z(), 0.1 * 0.08);
  EXPECT_DOUBLE_EQ(motion.top_velocity.x(), -0.1 * 0.08);
}

TEST(Servo, MovesBothPlanesAndNothingSidewaysWithoutAShearTarget) {
  const BoundaryMotion motion = servo_motion({1000.0, {}, 0.1}, cell, {0.0, 77.0, 0.0, 0.0, 0.0});
  EXPECT_DOUBLE_EQ(motion.top_velocity.z(), -0.05 * 0.08);
  EXPECT_DOUBLE_EQ(motion.bottom_velocity.z(), 0.05 * 0.08);
  EXPECT_EQ(motion.top_velocity.x(), 0.0);
}

TEST(Servo, DeviationIsTheWorstOfAllStresses) {
  const ServoTarget target{1000.0, 100.0, 0.1};
  EXPECT_DOUBLE_EQ(servo_deviation(target, {1000.0, 100.0, 0.0, 1000.0, 1000.0}), 0.0);
  EXPECT_DOUBLE_EQ(servo_deviation(target, {1000.0, 150.0, 0.0, 1010.0, 1000.0}), 0.05);
  EXPECT_DOUBLE_EQ(servo_deviation(target, {1000.0, 100.0, 0.0, 1000.0, 800.0}), 0.2);
}

}  // namespace
}  // namespace flowslide
