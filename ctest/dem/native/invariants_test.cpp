// SPDX-License-Identifier: GPL-2.0-or-later
// What no law and no scheme may change: momentum, energy, the observer, the names of the grains, the axes.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstdio>

#include "dem/native/native_engine.hpp"
#include "grains/contact_forces.hpp"
#include "grains/pair_constants.hpp"
#include "support/clustered_cloud.hpp"
#include "support/contact_switches.hpp"
#include "support/elastic_cloud.hpp"

namespace flowslide::invariants_test {
namespace {

constexpr double step = 1e-6;

Assembly run(const Assembly& start, const EngineSettings& settings, int steps) {
  DoubleEngine engine;
  engine.load(start, settings);
  engine.run(steps);
  return engine.save();
}

Vector3 momentum(const Assembly& a) {
  Vector3 sum = Vector3::Zero();
  for (std::size_t i = 0; i < a.size(); ++i) sum += sphere_mass(a.radius[i], Material{}) * a.velocity[i];
  return sum;
}

Vector3 angular_momentum(const Assembly& a) {
  Vector3 sum = Vector3::Zero();
  for (std::size_t i = 0; i < a.size(); ++i)
    sum += sphere_mass(a.radius[i], Material{}) * a.position[i].cross(a.velocity[i]) +
           sphere_inertia(a.radius[i], Material{}) * a.spin[i];
  return sum;
}

TEST(Invariants, MomentumAndAngularMomentumOfAFreeCloudAreKept) {
  // Rigid walls far away: a periodic cell keeps no angular momentum.
  Assembly cloud = clustered_cloud(11, cube(0.2, false), {.grains = 60, .overlap = 0.003});
  Material m;
  m.torsion_resistance = m.normal_force_limited = true;
  const Assembly after = run(cloud, {m, step, 0.0}, 2000);
  double scale = 0.0, angular_scale = 0.0;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const double size =
        sphere_mass(cloud.radius[i], Material{}) * (after.velocity[i].norm() + cloud.velocity[i].norm());
    scale += size;
    angular_scale += size * after.position[i].norm();
  }
  EXPECT_GT((after.velocity[0] - cloud.velocity[0]).norm(), 1e-3);  // contacts have acted
  // Rounding of 2000 steps of 60 grains, adding up at random: far below sqrt(1e5) 1e-16.
  EXPECT_LT((momentum(after) - momentum(cloud)).norm(), 1e-13 * scale);
  EXPECT_LT((angular_momentum(after) - angular_momentum(cloud)).norm(), 1e-13 * angular_scale);
}

TEST(Invariants, EnergyIsKeptWithoutDashpotsToTheOrderOfTheScheme) {
  const Material m = frictionless(1.0);
  const Assembly cloud = with_forces(clustered_cloud(12, cube(0.04, true), {.grains = 80, .overlap = 0.003}), m);
  const double before = energy(cloud);
  double drift[2] = {0.0, 0.0};
  for (const int fine : {0, 1}) {
    DoubleEngine engine;
    const double time_step = fine ? 0.5 * step : step;
    engine.load(cloud, {m, time_step, 0.0});
    for (int part = 0; part < 50; ++part) {
      engine.run(fine ? 8 : 4);
      drift[fine] = std::max(drift[fine], std::abs(energy(engine.save()) / before - 1.0));
    }
  }
  std::printf("relative drift %.2g, at half the step %.2g\n", drift[0], drift[1]);
  EXPECT_LT(drift[0], 2e-2);
  EXPECT_NEAR(std::log2(drift[0] / drift[1]), 2.0, 0.4);  // velocity Verlet: second order, up to the next
}

TEST(Invariants, EnergyNeverGrowsWithDashpots) {
  const Material m = frictionless(0.8);
  Assembly cloud = with_forces(clustered_cloud(13, cube(0.04, true), {.grains = 80, .overlap = 0.003}), m);
  DoubleEngine engine;
  engine.load(cloud, {m, 0.1 * step, 0.0});
  double before = energy(cloud);
  const double start = before;
  for (int part = 0; part < 200; ++part) {
    engine.run(10);
    const double now = energy(engine.save());
    // The scheme's own error of energy oscillates with dt^2: 2e-2 of it at 1 us, 2e-4 at 0.1 us (test above).
    EXPECT_LT(now, before + 2e-4 * start);
    before = std::min(before, now);
  }
  EXPECT_LT(before, 0.95 * start);
}

TEST(Invariants, FrictionRollingAndTorsionOnlyTakeEnergy) {
  for (const Material& m : with_all_switches({})) {
    const Assembly cloud = with_forces(
        clustered_cloud(14, cube(0.04, true), {.grains = 80, .overlap = 0.003, .spring = 0.0, .torque = 0.0}), m);
    const double start = energy(cloud);
    DoubleEngine engine;
    engine.load(cloud, {m, 0.1 * step, 0.0});
    for (int part = 0; part < 100; ++part) {
      engine.run(200);
      EXPECT_LT(energy(engine.save()), start * (1.0 + 2e-4)) << switches_of(m);
    }
    EXPECT_LT(energy(engine.save()), 0.9 * start) << switches_of(m);
  }
}

TEST(Invariants, AMovingObserverSeesTheSame) {
  const EngineSettings settings{Material{}, step, 0.0};
  const Assembly cloud = clustered_cloud(15, cube(0.04, true), {.grains = 80, .overlap = 0.003});
  const Vector3 wind(0.7, -0.4, 0.2);
  Assembly carried = cloud;
  for (Vector3& v : carried.velocity) v += wind;
  const int steps = 500;
  const Assembly still = run(cloud, settings, steps), moved = run(carried, settings, steps);
  double velocity = 0.0, position = 0.0;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    velocity = std::max(velocity, (moved.velocity[i] - wind - still.velocity[i]).norm());
    const Vector3 drift = moved.position[i] - still.position[i] - steps * step * wind;
    position = std::max(position, cloud.cell.nearest_image(drift).norm());
  }
  std::printf("velocity differs by %.2g m/s, position by %.2g m\n", velocity, position);
  // Coordinates round to 7e-18 m in each of 500 steps; k_n dt / m of the stiffest contacts makes 1e-12 m/s of each.
  EXPECT_LT(velocity, 1e-9);
  EXPECT_LT(position, 1e-12);
}

TEST(Invariants, ExchangeOfTwoGrainsChangesNoBit) {
  const EngineSettings settings{Material{}, step, 0.0};
  Assembly pair = clustered_cloud(16, cube(0.04, true), {.grains = 2});
  ASSERT_EQ(pair.contacts.size(), 1u);
  Assembly swapped = pair;
  for (auto* array : {&swapped.position, &swapped.velocity, &swapped.spin}) std::swap((*array)[0], (*array)[1]);
  std::swap(swapped.radius[0], swapped.radius[1]);
  swapped.contacts[0].tangential_spring *= -1.0;
  swapped.contacts[0].rolling_torque *= -1.0;
  for (const int steps : {1, 10, 100}) {
    const Assembly a = run(pair, settings, steps), b = run(swapped, settings, steps);
    for (const int i : {0, 1}) {
      EXPECT_EQ(a.position[i], b.position[1 - i]);
      EXPECT_EQ(a.velocity[i], b.velocity[1 - i]);
      EXPECT_EQ(a.spin[i], b.spin[1 - i]);
      EXPECT_EQ(a.force[i], b.force[1 - i]);
      EXPECT_EQ(a.torque[i], b.torque[1 - i]);
    }
  }
}

TEST(Invariants, AQuarterTurnAboutZTurnsTheAnswer) {
  // But for rounding: a sum of products is not rounded alike in another order.
  const auto turn = [](const Vector3& v) { return Vector3(-v.y(), v.x(), v.z()); };
  const EngineSettings settings{Material{}, step, 0.1};
  Assembly cloud = clustered_cloud(17, cube(0.04, false), {.grains = 80, .overlap = 0.003});
  Assembly turned = cloud;
  for (auto* array : {&turned.position, &turned.velocity, &turned.spin})
    for (Vector3& v : *array) v = turn(v);
  for (ContactHistory& contact : turned.contacts) {
    contact.tangential_spring = turn(contact.tangential_spring);
    contact.rolling_torque = turn(contact.rolling_torque);
  }
  ASSERT_GT(cloud.contacts.size(), 50u);
  const Assembly a = run(cloud, settings, 300), b = run(turned, settings, 300);
  const auto difference = [&](const std::vector<Vector3> Assembly::*array) {
    double largest = 0.0, scale = 0.0;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      largest = std::max(largest, (turn((a.*array)[i]) - (b.*array)[i]).norm());
      scale = std::max(scale, (a.*array)[i].norm());
    }
    std::printf("differs by %.1e of the largest\n", largest / scale);
    return largest / scale;
  };
  EXPECT_LT(difference(&Assembly::position), 1e-14);
  for (const auto array : {&Assembly::velocity, &Assembly::spin, &Assembly::force, &Assembly::torque})
    EXPECT_LT(difference(array), 1e-10);  // rounding, and what 300 steps of stiff contacts make of it
}

}  // namespace
}  // namespace flowslide::invariants_test
