// SPDX-License-Identifier: GPL-2.0-or-later
#include "sample/stable_time_step.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <stdexcept>
#include <utility>

#include "dem/native/native_engine.hpp"
#include "grains/time_step_share.hpp"
#include "sample/dem_sample.hpp"
#include "sample/health.hpp"
#include "support/clustered_cloud.hpp"
#include "support/elastic_cloud.hpp"
#include "support/touching_lattice.hpp"

namespace flowslide::stable_time_step_test {
namespace {

constexpr double step = 1e-6;  // s

TEST(StableTimeStep, IsAShareOfWhatTheContactsBear) {
  Assembly lattice = touching_lattice();
  const double share = time_step_share(lattice, Material{}, step);
  ASSERT_GT(share, 0.0);
  EXPECT_DOUBLE_EQ(stable_time_step(lattice, Material{}, step), 0.8 * time_step_below_edge(step, share));
}

TEST(StableTimeStep, FallsWithTheVelocityOfTheGrains) {
  Assembly gas = touching_lattice();
  for (double& radius : gas.radius) radius *= 0.5;  // no contacts
  for (Vector3& velocity : gas.velocity) velocity.setZero();
  Material elastic;
  elastic.restitution = 1.0;
  elastic.rolling_friction = 0.0;
  EXPECT_EQ(stable_time_step(gas, elastic, step), std::numeric_limits<double>::infinity());
  const auto at_speed = [&](double speed) {
    for (Vector3& velocity : gas.velocity) velocity = {0.0, speed, 0.0};
    return stable_time_step(gas, elastic, step);
  };
  // Hertz: the overlap grows as v^(4/5), the stiffness as v^(2/5), and the edge falls as v^(-1/5).
  EXPECT_NEAR(at_speed(0.32) / at_speed(0.01), 0.5, 5e-3);
}

TEST(StableTimeStep, KeepsTheEnergyOfElasticGrainsThatCollide) {
  const Material m = frictionless(1.0);
  Assembly cloud = clustered_cloud(12, cube(0.04, true), {.grains = 80, .overlap = 0.0005, .speed = 0.05});
  cloud = with_forces(std::move(cloud), m);
  const double before = energy(cloud);
  DoubleEngine engine(NativeOptions{.threads = 1});
  EngineSettings settings{m, 1e-7, 0.0};
  engine.load(cloud, settings);
  double longest = 0.0, drift = 0.0;
  for (int part = 0; part < 200; ++part) {
    settings.time_step = stable_time_step(engine.save(), m, settings.time_step);
    longest = std::max(longest, settings.time_step);
    engine.set(settings);
    engine.run(20);
    drift = std::max(drift, std::abs(energy(engine.save()) / before - 1.0));
  }
  std::printf("largest change of the energy %.2g of it, longest step %.2g s\n", drift, longest);
  // Verlet's error of energy in an impact is some (omega dt)^2/8; omega dt is at most 1.6.
  EXPECT_LT(drift, 0.32);
  EXPECT_GT(longest, 1e-6);
}

TEST(StableTimeStep, OfASoftSampleExceedsTheFractionOfTheRayleighTime) {
  Assembly lattice = touching_lattice();
  for (double& radius : lattice.radius) radius *= 0.9;  // no contact: the slow impacts to come bound the step
  const Material soft;
  DemSample sample(std::make_unique<DoubleEngine>(NativeOptions{.threads = 1}), lattice, {soft, step, 0.0});
  const double allowed = sample.stable_time_step();
  // A step up to the stable one is taken, a longer one is refused as any other above the limit.
  const double limit = longest_time_step(lattice.smallest_radius(), soft);
  ASSERT_GT(allowed, limit);
  EXPECT_NO_THROW(sample.strain({{1e-3, 0.0}, 1, allowed}));
  // The longer the present step, the closer the bound is to the edge: ask again.
  const double now_allowed = sample.stable_time_step();
  EXPECT_GE(now_allowed, allowed);
  EXPECT_THROW(sample.strain({{1e-3, 0.0}, 1, 1.01 * now_allowed}), std::invalid_argument);
}

}  // namespace
}  // namespace flowslide::stable_time_step_test
