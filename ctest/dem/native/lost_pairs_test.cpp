// SPDX-License-Identifier: GPL-2.0-or-later
// No pair and no plane that a grain meets between two builds of the pair list is lost.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "dem/native/native_engine.hpp"
#include "pair_search.hpp"

namespace flowslide {
namespace {

constexpr double time_step = 1e-6;  // s
const Vector3 still = Vector3::Zero();

/// Runs until grains touch; every touching pair must be known from its first step on. How often the list is built
/// depends on what the grains have done, so each allowance is tried.
void expect_found_in_time(const Assembly& start, const BoundaryMotion& motion, const char* how) {
  for (const double allowance : {1e-4, 1e-3, 0.01, 0.02, 1.0}) {
    DoubleEngine engine({.first_allowance = allowance});
    engine.load(start, {Material{}, time_step, 0.0});
    engine.move(motion);
    bool met = false;
    for (int s = 0; s < 600 && !met; ++s) {
      engine.run(1);
      const Assembly now = engine.save();
      const auto touching = native::every_touching_pair(now);
      ASSERT_EQ(now.contacts.size(), touching.size()) << how << ", step " << s << ", allowance " << allowance;
      met = !touching.empty();
    }
    ASSERT_TRUE(met) << how << ": they never met";
  }
}

/// Two grains in a cell of 40 mm, `gap` (m) apart along a direction, their middle at `centre`.
Assembly apart(double gap, const Vector3& direction, const Vector3& velocity, const Vector3& centre = still) {
  Assembly pair = clustered_cloud(1, cube(0.04, false), {.grains = 2, .smallest = 3e-3, .largest = 3e-3});
  pair.cell.periodic = {true, true, false};
  pair.contacts.clear();
  for (Vector3& spin : pair.spin) spin.setZero();
  const Vector3 half = 0.5 * (6e-3 + gap) * direction.normalized();
  pair.position = {centre - half, centre + half};
  pair.velocity = {velocity, -velocity};
  return pair;
}

TEST(LostPairs, FindsWhoMeetsHeadOn) {
  for (const double gap : {1e-5, 1.3e-4, 6.1e-4})
    for (const Vector3& direction : {Vector3(1, 0, 0), Vector3(0, 1, 0), Vector3(0, 0, 1), Vector3(1, 2, -1)})
      expect_found_in_time(apart(gap, direction, 2.0 * direction.normalized()), {}, "head on");
}

TEST(LostPairs, FindsARattlerThatHitsAGrainAtRest) {
  for (const double gap : {1e-5, 1.3e-4, 6.1e-4}) {
    Assembly pair = apart(gap, {1, 0, 0}, {4, 0, 0});
    pair.velocity[1].setZero();
    expect_found_in_time(pair, {}, "rattler");
  }
}

TEST(LostPairs, FindsWhoMeetsThroughAPeriodicFace) {
  expect_found_in_time(apart(1.3e-4, {1, 0, 0}, {1, 0, 0}, {0.0199, 0.0, 0.0}), {}, "through x");
  expect_found_in_time(apart(1.3e-4, {1, 1, 0}, {1, 1, 0}, {0.0199, -0.0199, 0.0}), {}, "through x and y");
}

TEST(LostPairs, FindsWhomCompressionBringsTogether) {
  expect_found_in_time(apart(1.3e-4, {1, 0, 0}, still), {still, still, 500.0, 0.0}, "along x");
  expect_found_in_time(apart(1.3e-4, {0, 1, 0}, still), {still, still, 0.0, 500.0}, "along y");
  expect_found_in_time(apart(1.3e-4, {1, 0, 0}, still, {0.0199, 0, 0}), {still, still, 500.0, 0.0}, "through x");
}

/// Grains that move with the boundaries' field, so that nothing but its gradient brings them together.
Assembly carried(Assembly grains, const Vector3& top) {
  for (std::size_t i = 0; i < grains.size(); ++i) grains.velocity[i] = (grains.position[i].z() + 0.02) / 0.04 * top;
  return grains;
}

TEST(LostPairs, FindsWhomShearBringsTogether) {
  const Vector3 top(40.0, 0.0, 0.0);
  for (const double gap : {1e-5, 1.3e-4, 6.1e-4})
    expect_found_in_time(carried(apart(gap, {1, 0, -1}, still), top), {still, top, 0.0, 0.0}, "sheared");
}

TEST(LostPairs, FindsWhomShearBringsTogetherThroughAPeriodicFaceAlongZ) {
  const Vector3 half_top(20.0, 0.0, 0.0);
  for (const double gap : {1e-5, 1.3e-4, 6.1e-4}) {
    Assembly pair = apart(gap, {1, 0, -1}, still, {0.0, 0.0, 0.0199});
    pair.cell.periodic[2] = true;
    pair.cell.shear_offset = 0.013;
    for (std::size_t i = 0; i < 2; ++i) pair.velocity[i] = pair.position[i].z() / 0.02 * half_top;
    pair.cell.shear_velocity = 2.0 * half_top.x();  // with which the upper one is folded
    expect_found_in_time(pair, {-half_top, half_top, 0.0, 0.0}, "sheared in a cell without planes");
  }
}

TEST(LostPairs, FindsWhomAShorterHeightBringsTogether) {
  for (const double middle : {0.0, 0.0199}) {
    Assembly pair = apart(1.3e-4, {0, 0, 1}, still, {0.0, 0.0, middle});
    pair.cell.periodic[2] = true;
    expect_found_in_time(pair, {Vector3(0, 0, 10.0), Vector3(0, 0, -10.0), 0.0, 0.0}, "along z");
  }
}

/// A grain that must bounce back from a plane instead of crossing it.
void expect_held(const Assembly& start, const BoundaryMotion& motion, const char* how) {
  for (const double allowance : {1e-4, 1e-3, 0.01, 0.02, 1.0}) {
    DoubleEngine engine({.first_allowance = allowance});
    engine.load(start, {Material{}, time_step, 0.0});
    engine.move(motion);
    double deepest = 0.0;
    for (int s = 0; s < 600; ++s) {
      engine.run(1);
      const Assembly now = engine.save();
      const Vector3 centre = 0.5 * (now.cell.upper + now.cell.lower), x = now.position[0] - centre;
      for (int axis = 0; axis < 3; ++axis)
        if (!now.cell.periodic[axis])
          deepest = std::max(deepest, std::abs(x[axis]) + now.radius[0] - 0.5 * now.cell.lengths()[axis]);
    }
    EXPECT_GT(deepest, 0.0) << how << ": it never met the plane";
    // An undamped impact of Hertz at 3 m/s is 0.07 mm deep.
    EXPECT_LT(deepest, 1e-4) << how << ", allowance " << allowance << ": the plane let it in";
  }
}

/// One grain, `gap` (m) off the upper plane along an axis, in a box without periods.
Assembly near_plane(int axis, double gap) {
  Assembly one = apart(0.01, {1, 0, 0}, still);
  one.cell.periodic = {false, false, false};
  one.position[1] = Vector3(-0.015, -0.015, -0.015);
  one.position[0] = Vector3(0.001, 0.002, 0.003);
  one.position[0][axis] = 0.02 - one.radius[0] - gap;
  return one;
}

TEST(LostPairs, FindsThePlaneThatAGrainRunsInto) {
  for (int axis = 0; axis < 3; ++axis)
    for (const double gap : {1e-5, 2.9e-4, 3.1e-4, 6e-4}) {
      Assembly start = near_plane(axis, gap);
      start.velocity[0][axis] = 3.0;
      expect_held(start, {}, "a grain that runs");
    }
}

TEST(LostPairs, FindsTheRigidSideThatComes) {
  // A side moves at rate L/2.
  for (const double gap : {2.9e-4, 3.01e-4, 6e-4}) {
    expect_held(near_plane(0, gap), {still, still, 100.0, 0.0}, "the side along x");
    expect_held(near_plane(1, gap), {still, still, 0.0, 100.0}, "the side along y");
    expect_held(near_plane(2, gap), {still, Vector3(0.0, 0.0, -2.0), 0.0, 0.0}, "the top");
  }
}

TEST(LostPairs, FindsTheRigidSideThatAGrainOfTheMeanFlowIsCarriedTo) {
  const Vector3 top(3.0, 0.0, 0.0);
  for (const double gap : {2.9e-4, 3.01e-4, 6e-4})
    expect_held(carried(near_plane(0, gap), top), {still, top, 0.0, 0.0}, "the side along x");
}

/// A cloud of which a few grains are far faster than the rest, run for some steps on some threads: all contacts of the
/// end must be known. Counts them, and those that are new.
void run_cloud(std::uint64_t seed, std::size_t most, std::size_t& contacts, std::size_t& fresh) {
  Assembly cloud = native::fuzzed_cloud(seed, most);
  Dice dice(seed);
  const double speed = dice.between(0.0, 4.0), slow = dice.below(2) == 0 ? 1.0 : 1e-3;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (cloud.role[i] == Role::mobile) cloud.velocity[i] = dice.vector(dice.below(5) == 0 ? speed : slow * speed);
  const double allowance = std::pow(10.0, dice.between(-5.0, 0.0));
  DoubleEngine engine({.threads = 1 + static_cast<int>(dice.below(4)), .first_allowance = allowance});
  engine.load(cloud, {Material{}, time_step, 0.0});
  const auto boundaries = [&](double largest_rate) {
    BoundaryMotion motion{dice.vector(0.5), dice.vector(0.5), dice.between(-1.0, 1.0) * largest_rate,
                          dice.between(-1.0, 1.0) * largest_rate};
    if (!cloud.cell.periodic[2]) return motion;
    motion.top_velocity.y() = motion.bottom_velocity.y();  // periodic faces slide along x alone, if at all
    if (!cloud.cell.periodic[0]) motion.top_velocity.x() = motion.bottom_velocity.x();
    if (dice.below(2) == 0) motion.top_velocity.z() = motion.bottom_velocity.z() = 0.0;
    return motion;
  };
  engine.move(boundaries(5.0));
  if (dice.below(2) == 0) engine.move(boundaries(0.0));  // ways are measured
  engine.run(1 + static_cast<int>(dice.below(60)));
  const Assembly now = engine.save();
  for (const Vector3& x : now.position) ASSERT_TRUE(x.allFinite()) << "seed " << seed;
  const auto expected = native::every_touching_pair(now);
  ASSERT_EQ(now.contacts.size(), expected.size()) << "seed " << seed;
  for (std::size_t c = 0; c < expected.size(); ++c) {
    ASSERT_EQ(now.contacts[c].first, expected[c].first) << "seed " << seed;
    ASSERT_EQ(now.contacts[c].second, expected[c].second) << "seed " << seed;
    fresh += std::none_of(cloud.contacts.begin(), cloud.contacts.end(), [&](const ContactHistory& known) {
      return known.first == expected[c].first && known.second == expected[c].second;
    });
  }
  contacts += expected.size();
}

TEST(LostPairs, NoneOfTenThousandRandomCloudsInMotion) {
  std::size_t contacts = 0, fresh = 0;
  for (std::uint64_t seed = 0; seed < 10000; ++seed) {
    run_cloud(seed, seed % 20 == 0 ? 240 : 24, contacts, fresh);  // more than 64 grains work on several threads
    ASSERT_FALSE(HasFailure());
  }
  std::printf("%zu contacts, %zu of them new\n", contacts, fresh);
  EXPECT_GT(contacts, 10000u);
  EXPECT_GT(fresh, 1000u);  // contacts that the list had to find in time
}

}  // namespace
}  // namespace flowslide
