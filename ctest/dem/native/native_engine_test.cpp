// SPDX-License-Identifier: GPL-2.0-or-later
#include "dem/native/native_engine.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "grains/contact_search.hpp"
#include "pair_search.hpp"
#include "support/touching_lattice.hpp"

namespace flowslide {
namespace {

constexpr double step = 2e-6;
const EngineSettings settings{Material{}, step, 0.0};

/// Sheared fast enough for contacts to open and close and for grains to cross the periodic faces.
BoundaryMotion shear(double speed) { return {Vector3::Zero(), {speed, 0.3 * speed, -0.01}, 0.1, -0.1}; }

void expect_same_bits(const Assembly& a, const Assembly& b) {
  ASSERT_EQ(a.size(), b.size());
  std::size_t different = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    different += a.position[i] != b.position[i] || a.velocity[i] != b.velocity[i] || a.spin[i] != b.spin[i] ||
                 a.force[i] != b.force[i] || a.torque[i] != b.torque[i];
  EXPECT_EQ(different, 0u) << "of " << a.size() << " grains";
  ASSERT_EQ(a.contacts.size(), b.contacts.size());
  for (std::size_t c = 0; c < a.contacts.size(); ++c) {
    EXPECT_EQ(a.contacts[c].first, b.contacts[c].first);
    EXPECT_EQ(a.contacts[c].second, b.contacts[c].second);
    EXPECT_EQ(a.contacts[c].tangential_spring, b.contacts[c].tangential_spring);
    EXPECT_EQ(a.contacts[c].rolling_torque, b.contacts[c].rolling_torque);
  }
}

Assembly sheared(double skin, double speed, int steps) {
  NativeEngine engine(skin);
  engine.load(touching_lattice(), settings);
  engine.move(shear(speed));
  engine.run(steps);
  return engine.save();
}

TEST(NativeEngine, GivesTheSameBitsAgainAndForAnySkin) {
  const Assembly first = sheared(0.01, 1.0, 1000);
  expect_same_bits(first, sheared(0.01, 1.0, 1000));
  for (const double skin : {0.002, 0.03, 0.1}) expect_same_bits(first, sheared(skin, 1.0, 1000));
}

TEST(NativeEngine, GivesTheSameBitsForAnySkinWhenGrainsCrossTheFacesOfTheCell) {
  const Assembly start = touching_lattice(), first = sheared(0.01, 4.0, 2000);
  std::size_t crossed = 0;
  for (std::size_t i = 0; i < start.size(); ++i)
    crossed += std::abs(first.position[i].x() - start.position[i].x()) > 0.02;
  ASSERT_GT(crossed, 3u);
  for (const double skin : {0.002, 0.03, 0.1}) expect_same_bits(first, sheared(skin, 4.0, 2000));
}

TEST(NativeEngine, ManyShortRunsGiveTheBitsOfOneLongRun) {
  NativeEngine whole, parts;
  for (NativeEngine* engine : {&whole, &parts}) {
    engine->load(touching_lattice(), settings);
    engine->move(shear(1.0));
  }
  whole.run(60);
  for (int i = 0; i < 20; ++i) parts.run(3);
  expect_same_bits(whole.save(), parts.save());
  EXPECT_EQ(whole.cell_stress().normal, parts.cell_stress().normal);
  EXPECT_EQ(whole.cell_stress().lateral_x, parts.cell_stress().lateral_x);
  parts.run(0);
  expect_same_bits(whole.save(), parts.save());
}

TEST(NativeEngine, LoadsWhatItSavedAndKnowsItsStress) {
  Assembly boxed = clustered_cloud(21, cube(0.03, false), {.grains = 100});
  boxed.cell.upper.setConstant(-0.015);
  for (std::size_t i = 0; i < boxed.size(); ++i)  // planes that touch the outermost grain of each axis
    boxed.cell.upper = boxed.cell.upper.cwiseMax((boxed.position[i].array() + 0.99 * boxed.radius[i]).matrix());
  NativeEngine engine, again;
  const EngineSettings dragged{Material{}, 1e-7, 0.1};
  engine.load(boxed, dragged);
  engine.run(3);
  again.load(engine.save(), dragged);
  expect_same_bits(again.save(), engine.save());
  const CellStress before = engine.cell_stress(), after = again.cell_stress();
  ASSERT_NE(before.normal, 0.0);
  // Sums of some 400 rounded terms, and the forces evaluated once more.
  EXPECT_NEAR(after.normal, before.normal, 1e-9 * std::abs(before.normal));
  EXPECT_NEAR(after.lateral_x, before.lateral_x, 1e-9 * std::abs(before.normal));
  EXPECT_NEAR(after.lateral_y, before.lateral_y, 1e-9 * std::abs(before.normal));
}

TEST(NativeEngine, RefusesAPeriodicCellTooSmallForItsGrains) {
  NativeEngine engine;
  Assembly pair = clustered_cloud(1, cube(0.04, true), {.grains = 2, .smallest = 3e-3, .largest = 3e-3});
  EXPECT_NO_THROW(engine.load(pair, settings));
  for (int axis = 0; axis < 3; ++axis) {
    Assembly narrow = pair;
    narrow.position = {Vector3::Zero(), Vector3::Constant(5e-3)};
    narrow.contacts.clear();
    narrow.cell.lower[axis] = -6e-3;
    narrow.cell.upper[axis] = 6e-3;  // two diameters, without the reach of the list
    EXPECT_THROW(engine.load(narrow, settings), EngineError) << axis;
    narrow.cell.periodic[axis] = false;
    EXPECT_NO_THROW(engine.load(narrow, settings)) << axis;
  }
}

TEST(NativeEngine, NoticesGrainsOutsideItsPlanesAndLostNumbers) {
  NativeEngine engine;
  Assembly cloud = clustered_cloud(2, cube(0.1, false), {.grains = 10});
  engine.load(cloud, settings);
  EXPECT_EQ(engine.count_grains(), 10u);
  Assembly outside = cloud;
  outside.position[3].y() = 0.06;
  EXPECT_THROW(engine.load(outside, settings), EngineError);
  for (const bool periodic : {true, false}) {
    Assembly broken = cloud;
    broken.cell.periodic = {periodic, periodic, periodic};
    broken.velocity[4].x() = std::numeric_limits<double>::quiet_NaN();
    engine.load(broken, settings);
    engine.run(2);
    EXPECT_LT(engine.count_grains(), 10u) << "periodic " << periodic;
  }
  cloud.velocity[5] = Vector3(0.0, 0.0, 1e6);
  engine.load(cloud, settings);
  engine.run(2);
  EXPECT_EQ(engine.count_grains(), 9u);
}

/// Pairs that touch, by looking at every one.
std::vector<TouchingPair> every_touching_pair(const Assembly& a) {
  std::vector<TouchingPair> pairs;
  for (std::uint32_t i = 0; i < a.size(); ++i)
    for (std::uint32_t j = i + 1; j < a.size(); ++j)
      if (!in_one_layer(a, i, j) &&
          a.cell.nearest_image(a.position[i] - a.position[j]).norm() < a.radius[i] + a.radius[j])
        pairs.push_back({i, j});
  return pairs;
}

/// Two grains just beyond the skin that approach as fast as the bound on their approach allows.
void expect_found_in_time(Assembly pair, const BoundaryMotion& motion, const char* how) {
  constexpr double skin = 0.02, time_step = 1e-6;
  NativeEngine engine(skin);
  engine.load(pair, {Material{}, time_step, 0.0});
  engine.move(motion);
  for (int s = 0; s < 200; ++s) {
    engine.run(1);
    const Assembly now = engine.save();
    const auto touching = every_touching_pair(now);
    ASSERT_EQ(now.contacts.size(), touching.size()) << how << ", step " << s;
    if (!touching.empty()) return;
  }
  FAIL() << how << ": they never met";
}

TEST(NativeEngine, FindsPairsThatMeetHeadOnOrCarriedByTheBoundaries) {
  Assembly pair = clustered_cloud(1, cube(0.04, false), {.grains = 2, .smallest = 3e-3, .largest = 3e-3});
  pair.cell.periodic = {true, true, false};
  pair.contacts.clear();
  for (Vector3& spin : pair.spin) spin.setZero();
  const auto apart = [&](const Vector3& direction, const Vector3& velocity) {
    Assembly both = pair;
    const Vector3 half = 0.5 * (6e-3 + 1.05 * 0.02 * 6e-3) * direction.normalized();
    both.position = {-half, half};
    both.velocity = {velocity, -velocity};
    return both;
  };
  expect_found_in_time(apart({1, 0, 0}, {1, 0, 0}), {}, "head on");
  const Vector3 still = Vector3::Zero();
  expect_found_in_time(apart({1, 0, 0}, still), {still, still, 500.0, 0.0}, "compressed along x");
  expect_found_in_time(apart({0, 1, 0}, still), {still, still, 0.0, 500.0}, "compressed along y");
  // Both move with the mean flow, so that nothing but its gradient brings them together.
  const Vector3 top(40.0, 0.0, 0.0);
  Assembly carried = apart({1, 0, -1}, still);
  for (std::size_t i = 0; i < 2; ++i) carried.velocity[i] = (carried.position[i].z() + 0.02) / 0.04 * top;
  expect_found_in_time(carried, {still, top, 0.0, 0.0}, "sheared");
}

TEST(NativeEngine, LosesNoPairOfTenThousandRandomCloudsInMotion) {
  std::size_t contacts = 0, fresh = 0;
  for (std::uint64_t seed = 0; seed < 10000; ++seed) {
    Assembly cloud = native::fuzzed_cloud(seed);
    Dice dice(seed);
    const double speed = dice.between(0.0, 4.0);
    for (std::size_t i = 0; i < cloud.size(); ++i)
      if (cloud.role[i] == Role::mobile) cloud.velocity[i] = dice.vector(speed);
    NativeEngine engine(dice.between(0.002, 0.1));
    engine.load(cloud, {Material{}, 1e-6, 0.0});
    engine.move({dice.vector(0.5), dice.vector(0.5), dice.between(-5.0, 5.0), dice.between(-5.0, 5.0)});
    engine.run(1 + static_cast<int>(dice.below(60)));
    const Assembly now = engine.save();
    for (const Vector3& x : now.position) ASSERT_TRUE(x.allFinite()) << "seed " << seed;
    const auto expected = every_touching_pair(now);
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
  std::printf("%zu contacts, %zu of them new\n", contacts, fresh);
  EXPECT_GT(contacts, 10000u);
  EXPECT_GT(fresh, 1000u);  // contacts that the list had to find in time
}

}  // namespace
}  // namespace flowslide
