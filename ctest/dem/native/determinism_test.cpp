// SPDX-License-Identifier: GPL-2.0-or-later
// Results have the same bits for any number of threads, pair list, instruction set and partition into runs.
#include <gtest/gtest.h>

#include <algorithm>
#include <cinttypes>
#include <cstdio>
#include <memory>

#include "same_bits.hpp"
#include "support/clustered_cloud.hpp"

namespace flowslide::determinism_test {
namespace {

constexpr double step = 2e-6;

/// An initial state, the motion of its boundaries and the number of steps.
struct Scene {
  const char* name;
  Assembly start;
  EngineSettings settings;
  BoundaryMotion motion;
  int steps;
};

Assembly in_box(bool periodic, double spring = 1e-8, double torque = 1e-8) {
  return clustered_cloud(31, cube(0.05, periodic),
                         {.grains = 330, .speed = 2.0, .spring = spring, .torque = torque});
}

/// Its images are numbered anew on the way.
Assembly in_sheared_box() {
  Cell cell = cube(0.05, true);
  cell.shear_offset = 0.0245;
  cell.shear_velocity = 5.0;
  return clustered_cloud(31, cell, {.grains = 330, .speed = 2.0});
}

std::vector<Scene> scenes() {
  const Vector3 still = Vector3::Zero();
  const EngineSettings settings{Material{}, step, 0.0};
  Material sliding;
  sliding.rolling_friction = 0.0;
  Material smooth = sliding;
  smooth.sliding_friction = 0.0;
  return {{"sheared across the faces", touching_lattice(), settings, {still, {4.0, 1.2, -0.01}, 0.0, 0.0}, 1500},
          {"sheared and compressed", touching_lattice(), settings, {still, {1.0, 0.3, -0.1}, 1.0, -0.5}, 400},
          {"shaken in a rigid box", in_box(false), {Material{}, step, 0.1}, {still, still, 1.0, 2.0}, 400},
          {"shaken with drag relative to the compression",
           in_box(false),
           {Material{}, step, 0.1, DragReference::uniform_compression},
           {still, still, 1.0, 2.0},
           400},
          {"sheared with drag relative to the shear",
           touching_lattice(),
           {Material{}, step, 0.1, DragReference::uniform_compression},
           {still, {1.0, 0.3, -0.1}, 1.0, -0.5},
           400},
          {"in a cell without planes", in_box(true), settings, {}, 400},
          {"in a cell that shrinks", in_box(true, 1e-8, 0.0), {sliding, step, 0.0}, {still, still, 5.0, 5.0}, 400},
          {"in a sheared cell", in_sheared_box(), settings, {still, {5.0, 0.0, 0.0}, 0.0, 0.0}, 400},
          {"in a sheared cell that shrinks", in_sheared_box(), settings, {still, {3.0, 0.0, -0.2}, 2.0, -1.0}, 400},
          {"without friction", in_box(false, 0.0, 0.0), {smooth, step, 0.0}, {}, 400}};
}

template <typename Real>
std::unique_ptr<Engine> ran(const Scene& scene, const NativeOptions& options) {
  auto engine = std::make_unique<NativeEngine<Real>>(options);
  engine->load(scene.start, scene.settings);
  engine->move(scene.motion);
  engine->run(scene.steps);
  return engine;
}

template <typename Real>
class DeterminismOf : public testing::Test {};
using Precisions = testing::Types<double, float>;
TYPED_TEST_SUITE(DeterminismOf, Precisions);

TYPED_TEST(DeterminismOf, AnyNumberOfThreadsGivesTheSameBits) {
  for (const Scene& scene : scenes()) {
    const auto alone = ran<TypeParam>(scene, {.threads = 1});
    for (const int threads : {2, 3, 5}) {
      const auto team = ran<TypeParam>(scene, {.threads = threads});
      const auto blocks = static_cast<int>((scene.start.size() + native::block_size - 1) / native::block_size);
      ASSERT_EQ(dynamic_cast<NativeEngine<TypeParam>&>(*team).threads(), std::min(threads, blocks));
      expect_same_bits(*alone, *team, std::string(scene.name) + ", threads " + std::to_string(threads));
    }
  }
}

TYPED_TEST(DeterminismOf, AnyAllowanceGivesTheSameBits) {
  for (const Scene& scene : scenes()) {
    const auto expected = ran<TypeParam>(scene, {.threads = 1});
    for (const double allowance : {0.0, 1e-5, 1e-2, 10.0})
      expect_same_bits(*expected, *ran<TypeParam>(scene, {.threads = 1, .first_allowance = allowance}),
                       std::string(scene.name) + ", allowance " + std::to_string(allowance));
  }
}

TYPED_TEST(DeterminismOf, AnyInstructionSetGivesTheSameBits) {
  for (const Scene& scene : scenes()) {
    const auto expected = ran<TypeParam>(scene, {.threads = 1});
    for (const std::string& set : native::instruction_sets())
      expect_same_bits(*expected, *ran<TypeParam>(scene, {.threads = 1, .instruction_set = set}),
                       std::string(scene.name) + ", " + set);
  }
}

TYPED_TEST(DeterminismOf, AnyPartitionOfRunsGivesTheSameBits) {
  Dice dice(1);
  for (const Scene& scene : scenes())
    for (const int threads : {1, 3}) {
      const auto whole = ran<TypeParam>(scene, {.threads = 1});
      NativeEngine<TypeParam> parts({.threads = threads});
      parts.load(scene.start, scene.settings);
      parts.move(scene.motion);
      for (int left = scene.steps; left > 0;) {
        const int some = std::min(left, static_cast<int>(dice.below(40)));
        parts.run(some);
        left -= some;
      }
      expect_same_bits(*whole, parts, scene.name);
    }
}

TYPED_TEST(DeterminismOf, WhatIsLoadedAgainGoesOnWithTheSameBitsOnAnyNumberOfThreads) {
  for (const Scene& scene : scenes()) {
    const auto first = ran<TypeParam>(scene, {.threads = 2});
    const Assembly saved = first->save();
    NativeEngine<TypeParam> again({.threads = 1});
    again.load(saved, scene.settings);
    expect_same_bits(again.save(), saved, scene.name);
    for (const int threads : {2, 3}) {
      NativeEngine<TypeParam> team({.threads = threads, .first_allowance = 0.01});
      team.load(saved, scene.settings);
      for (Engine* engine : {static_cast<Engine*>(&again), static_cast<Engine*>(&team)}) {
        engine->load(saved, scene.settings);
        engine->move(scene.motion);
        engine->run(100);
      }
      expect_same_bits(again, team, scene.name);
    }
    // The engine that was saved continues with the same bits, too.
    first->run(100);
    expect_same_bits(*first, again, std::string(scene.name) + ", not loaded again");
  }
}

/// 1000 steps of the lattice, sheared across its faces and compressed.
template <typename Real>
std::uint64_t golden(const NativeOptions& options) {
  const BoundaryMotion motion{Vector3::Zero(), {2.0, 0.5, -0.02}, 0.3, -0.2};
  const Scene scene{"", touching_lattice(), {Material{}, step, 0.05}, motion, 1000};
  return fingerprint(*ran<Real>(scene, options));
}

/// The same with g++ and clang++, with and without optimization, on any processor. They change
/// when the law, the scheme or the order of operations does, and then every stored result does: state it in the
/// changelog when you write new ones.
constexpr std::uint64_t golden_of_double = 0x10f7bf0e497ba73c, golden_of_mixed = 0x85ace57d13139661;

TEST(Determinism, AThousandStepsGiveTheBitsThatAreWrittenHere) {
  for (const std::string& set : native::instruction_sets())
    for (const int threads : {1, 3}) {
      const NativeOptions options{.threads = threads, .instruction_set = set};
      const std::uint64_t in_double = golden<double>(options), mixed = golden<float>(options);
      std::printf("%-8s %d threads: double 0x%016" PRIx64 ", mixed 0x%016" PRIx64 "\n", set.c_str(), threads, in_double,
                  mixed);
      EXPECT_EQ(in_double, golden_of_double);
      EXPECT_EQ(mixed, golden_of_mixed);
    }
}

}  // namespace
}  // namespace flowslide::determinism_test
