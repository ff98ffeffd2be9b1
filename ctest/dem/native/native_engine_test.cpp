// SPDX-License-Identifier: GPL-2.0-or-later
#include "dem/native/native_engine.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <thread>

#include "same_bits.hpp"
#include "support/clustered_cloud.hpp"

namespace flowslide::native_engine_test {
namespace {

constexpr double step = 2e-6;
const EngineSettings settings{Material{}, step, 0.0};

TEST(NativeEngine, LoadsWhatItSavedAndKnowsItsStress) {
  Assembly boxed = clustered_cloud(21, cube(0.03, false), {.grains = 100});
  boxed.cell.upper.setConstant(-0.015);
  for (std::size_t i = 0; i < boxed.size(); ++i)  // planes that touch the outermost grain of each axis
    boxed.cell.upper = boxed.cell.upper.cwiseMax((boxed.position[i].array() + 0.99 * boxed.radius[i]).matrix());
  DoubleEngine engine, again;
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
  DoubleEngine engine;
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
  DoubleEngine engine;
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

TEST(NativeEngine, ChoosesItsThreadsAndRefusesWhatItCannotDo) {
  EXPECT_THROW(DoubleEngine({.threads = -1}), EngineError);
  EXPECT_THROW(MixedEngine({.threads = -2}), EngineError);
  const auto threads_of = [](int threads, const Assembly& assembly) {
    MixedEngine engine({.threads = threads});
    engine.load(assembly, settings);
    return engine.threads();
  };
  EXPECT_EQ(threads_of(0, touching_lattice()), 1);  // fewer than 10 000 grains
  EXPECT_EQ(threads_of(2, touching_lattice()), 2);
  EXPECT_EQ(threads_of(100, touching_lattice()), 4);  // a block of 64 grains for each
  const int cores = static_cast<int>(std::thread::hardware_concurrency());
  EXPECT_EQ(threads_of(0, touching_lattice(22, 22)), std::max(1, cores));
  DoubleEngine engine({.instruction_set = "sse"});
  EXPECT_THROW(engine.load(touching_lattice(), settings), std::invalid_argument);
}

TEST(NativeEngine, NamesItsPrecision) {
  EXPECT_EQ(DoubleEngine().name(), "native");
  EXPECT_EQ(MixedEngine().name(), "native-mixed");
}

TEST(NativeEngine, TakesAnotherAssemblyOfAnotherSize) {
  DoubleEngine engine({.threads = 3}), fresh({.threads = 3});
  engine.load(touching_lattice(), settings);
  engine.run(7);
  for (const Assembly& other : {clustered_cloud(5, cube(0.04, true), {.grains = 20}), touching_lattice(7, 8)}) {
    engine.load(other, settings);
    fresh.load(other, settings);
    for (DoubleEngine* e : {&engine, &fresh}) e->run(20);
    expect_same_bits(engine, fresh);
  }
}

/// A stage of preparation without friction, between others with it.
TEST(NativeEngine, FrictionlessStepsClearTheSpringsAndTorquesAsTheLawDoes) {
  const Assembly cloud = clustered_cloud(6, cube(0.04, true), {.grains = 60, .overlap = 0.003});
  EngineSettings smooth = settings;
  smooth.material.sliding_friction = smooth.material.rolling_friction = 0.0;  // caps of 0
  DoubleEngine engine;
  engine.load(cloud, smooth);
  engine.run(1);
  const Assembly after = engine.save();
  ASSERT_FALSE(after.contacts.empty());
  for (const ContactHistory& contact : after.contacts) {
    EXPECT_EQ(contact.tangential_spring.norm(), 0.0);
    EXPECT_EQ(contact.rolling_torque.norm(), 0.0);
  }
}

}  // namespace
}  // namespace flowslide::native_engine_test
