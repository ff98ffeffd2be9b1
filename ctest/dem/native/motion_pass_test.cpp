// SPDX-License-Identifier: GPL-2.0-or-later
#include "dem/native/motion_pass.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "moving_bodies.hpp"

namespace flowslide::native::motion_pass_test {
namespace {

template <typename Real>
class MotionPassOf : public testing::Test {};
using Precisions = testing::Types<double, float>;
TYPED_TEST_SUITE(MotionPassOf, Precisions);

constexpr MotionPart parts[] = {MotionPart::end, MotionPart::begin, MotionPart::end_and_begin};

template <typename Real>
Passes<Real> widest() {
  return passes<Real>(instruction_sets().back());
}

TYPED_TEST(MotionPassOf, IsVelocityVerletInDouble) {
  for (const MotionPart part : parts) {
    MovingBodies<TypeParam> moving;
    const MovingBodies<TypeParam> before;
    const MotionExtremes extremes = moving.move(widest<TypeParam>(), part);
    Vector3 fastest = Vector3::Zero();
    for (std::size_t i = 0; i < before.bodies.size(); ++i) {
      const Body<double>& body = before.bodies[i];
      Vector3 velocity = Vector3::Map(body.velocity), spin = Vector3::Map(body.spin);
      for (int kicks = part == MotionPart::end_and_begin ? 2 : 1; kicks > 0; --kicks) {
        velocity += before.kick[i] * vector_of(before.loads[i].force);
        spin += before.twist[i] * vector_of(before.loads[i].torque);
      }
      Vector3 position = Vector3::Map(body.position);
      const Vector3 flow =
          Vector3::Map(moving.flow.base) + (position.z() - moving.flow.origin) * Vector3::Map(moving.flow.slope);
      if (part != MotionPart::end) position += pass_step * velocity;
      fastest = fastest.cwiseMax((velocity - flow).cwiseAbs2());
      const Body<double>& moved = moving.after(part)[i];
      EXPECT_EQ(Vector3::Map(moved.velocity), velocity);
      EXPECT_EQ(Vector3::Map(moved.spin), spin);
      EXPECT_EQ(Vector3::Map(moved.position), position);
      EXPECT_EQ(moved.radius, body.radius);
      EXPECT_EQ(moved.mass, body.mass);
      EXPECT_EQ(moved.inertia, body.inertia);
      // A part with a beginning clears the loads; an end alone keeps them.
      const double left = part == MotionPart::end ? 1.0 : 0.0;
      EXPECT_EQ(vector_of(moving.loads[i].force), left * vector_of(before.loads[i].force));
      EXPECT_EQ(vector_of(moving.loads[i].torque), left * vector_of(before.loads[i].torque));
    }
    // A bound: the largest of each component. A few rounded operations.
    const double bound = part == MotionPart::end ? 0.0 : fastest.sum();
    EXPECT_NEAR(extremes.fluctuation_squared, bound, 2e-15 * bound);
  }
}

TEST(MotionPass, InFloatABeginningPublishesWhatItHasMoved) {
  for (const MotionPart part : parts) {
    MovingBodies<float> moving;
    const std::vector<Body<float>> before = moving.published;
    moving.move(widest<float>(), part);
    for (std::size_t i = 0; i < before.size(); ++i) {
      const Body<float> expected = part == MotionPart::end ? before[i] : in_precision<float>(moving.bodies[i]);
      EXPECT_EQ(std::memcmp(&moving.published[i], &expected, sizeof expected), 0);
    }
  }
}

TEST(MotionPass, InDoubleABeginningLeavesWhatOthersRead) {
  const MovingBodies<double> before;
  MovingBodies<double> moving;
  moving.move(widest<double>(), MotionPart::end_and_begin);
  EXPECT_EQ(std::memcmp(moving.bodies.data(), before.bodies.data(), 41 * sizeof(Body<double>)), 0);
}

TYPED_TEST(MotionPassOf, AShareLeavesOthersAlone) {
  const Passes<TypeParam> here = widest<TypeParam>();
  MovingBodies<TypeParam> whole, part;
  const MovingBodies<TypeParam> before;
  whole.move(here, MotionPart::end_and_begin);
  here.motion(MotionPart::end_and_begin, pass_step, part.flow, part.box, part.grains(10, 30));
  for (std::size_t i = 0; i < whole.bodies.size(); ++i) {
    const auto& expected = i >= 10 && i < 30 ? whole : before;
    EXPECT_EQ(std::memcmp(&part.bodies[i], &expected.bodies[i], sizeof part.bodies[i]), 0);
    EXPECT_EQ(std::memcmp(&part.published[i], &expected.published[i], sizeof part.published[i]), 0);
    EXPECT_EQ(std::memcmp(&part.loads[i], &expected.loads[i], sizeof part.loads[i]), 0);
  }
}

TEST(MotionPass, OfASingleWorkerMovesInPlace) {
  MovingBodies<double> apart, in_place(41, false);
  for (MovingBodies<double>* moving : {&apart, &in_place}) moving->move(widest<double>(), MotionPart::begin);
  EXPECT_EQ(std::memcmp(apart.published.data(), in_place.bodies.data(), 41 * sizeof(Body<double>)), 0);
}

TYPED_TEST(MotionPassOf, NoticesWhoLeavesTheBox) {
  const auto leaves = [](int axis, double coordinate, double lower, double upper) {
    MovingBodies<TypeParam> moving;
    for (int k = 0; k < 4; ++k) {
      moving.box.lower[k] = -std::numeric_limits<double>::infinity();
      moving.box.upper[k] = std::numeric_limits<double>::infinity();
    }
    moving.box.lower[axis] = lower;
    moving.box.upper[axis] = upper;
    for (Body<double>& body : moving.bodies) {
      Vector3::Map(body.velocity).setZero();
      Vector3::Map(body.position).setConstant(0.5 * (lower + upper));
    }
    moving.loads.assign(moving.bodies.size(), {});
    moving.bodies[17].position[axis] = coordinate;
    return moving.move(widest<TypeParam>(), MotionPart::begin).outside;
  };
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_FALSE(leaves(axis, 0.01, -0.02, 0.02));
    EXPECT_FALSE(leaves(axis, -0.02, -0.02, 0.02));
    EXPECT_TRUE(leaves(axis, 0.02, -0.02, 0.02));  // the upper face belongs to the next period
    EXPECT_TRUE(leaves(axis, std::nextafter(-0.02, -1.0), -0.02, 0.02));
  }
}

TYPED_TEST(MotionPassOf, SlackIsTheLeastThatIsLeftOfTheAllowances) {
  MovingBodies<TypeParam> moving;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < moving.bodies.size(); ++i) {
    const Vector3 from = Vector3::Map(moving.start[i].position);
    const Vector3 drifted = from + Vector3::Map(moving.drift.offset) + from.z() * Vector3::Map(moving.drift.gradient);
    least = std::min(least, moving.start[i].allowance - (Vector3::Map(moving.bodies[i].position) - drifted).norm());
  }
  EXPECT_NEAR(moving.slack(widest<TypeParam>()), least, 1e-16);  // m: coordinates of 0.1 m round to 1.4e-17
}

TYPED_TEST(MotionPassOf, MomentsCountWhoIsInsideAndGluedGrainsAlongPeriodicAxesOnly) {
  MovingBodies<TypeParam> moving;
  for (double* y : {&moving.bodies[4].position[1], &moving.grains().published[4].position[1]})
    *y = std::numeric_limits<double>::quiet_NaN();
  Vector3 height = Vector3::Zero(), moment = Vector3::Zero();
  std::size_t inside = 0;
  for (std::size_t i = 0; i < moving.bodies.size(); ++i) {
    const Vector3 position = Vector3::Map(moving.bodies[i].position);
    const Vector3 arm = position - Vector3::Map(moving.origin), force = vector_of(moving.loads[i].force);
    inside += std::abs(position.x()) <= 0.2 && std::abs(position.y()) <= 0.05;
    if (i % 3 == 0) {
      moment.x() += arm.x() * force.x();
      continue;
    }
    height += arm.z() * force;
    moment += arm.cwiseProduct(force);
  }
  const Moments sums = moving.moments(widest<TypeParam>());
  EXPECT_EQ(sums.inside, inside);
  EXPECT_LT(inside, moving.bodies.size() - 5);
  // Sums of 41 terms of 0.3 N m, rounded in double.
  EXPECT_LT((Vector3::Map(sums.height_times_force) - height).norm(), 1e-14);
  EXPECT_NEAR(sums.moment[0], moment.x(), 1e-14);
  EXPECT_NEAR(sums.moment[2], moment.z(), 1e-14);
  EXPECT_TRUE(std::isnan(sums.moment[1]));  // a lost number is not hidden
}

TEST(MeanDrift, IsWhatGrainsOfTheMeanFlowDo) {
  const MeanFlow flow{{0.1, 0.2, 0.3, 0.0}, {3.0, 2.0, 1.0, 0.0}, 0.01};
  MeanDrift drift;
  for (int i = 0; i < 10; ++i) drift.add(flow, 1e-3);
  const Vector3 expected = 1e-2 * (Vector3(0.1, 0.2, 0.3) + (0.05 - 0.01) * Vector3(3.0, 2.0, 1.0));
  EXPECT_LT((Vector3::Map(drift.offset) + 0.05 * Vector3::Map(drift.gradient) - expected).norm(), 1e-17);
  EXPECT_NEAR(drift.steepness(), 1e-2 * std::sqrt(14.0), 1e-16);
}

}  // namespace
}  // namespace flowslide::native::motion_pass_test
