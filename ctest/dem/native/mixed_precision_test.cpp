// SPDX-License-Identifier: GPL-2.0-or-later
// What is lost when the law works in float.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "dem/native/native_engine.hpp"
#include "grains/contact_forces.hpp"
#include "grains/contact_law.hpp"
#include "support/clustered_cloud.hpp"
#include "support/touching_lattice.hpp"

namespace flowslide {
namespace {

/// A lattice that drag has brought to rest under load.
Assembly dense(double time_step) {
  DoubleEngine engine;
  engine.load(touching_lattice(), {Material{}, time_step, 0.5});
  engine.run(3000);
  return engine.save();
}

TEST(MixedPrecision, StressOfAShortShearIsThatOfDouble) {
  constexpr double time_step = 2e-6, rate = 1.0;  // s, 1/s
  const Assembly start = dense(time_step);
  const BoundaryMotion motion{Vector3::Zero(), {rate * start.cell.height(), 0.0, 0.0}, 0.0, 0.0};
  DoubleEngine exact;
  MixedEngine mixed;
  for (Engine* engine : {static_cast<Engine*>(&exact), static_cast<Engine*>(&mixed)}) {
    engine->load(start, {Material{}, time_step, 0.0});
    engine->move(motion);
  }
  double largest = 0.0;
  for (int part = 0; part < 25; ++part) {  // 0.05 % of strain
    exact.run(10);
    mixed.run(10);
    const CellStress a = exact.cell_stress(), b = mixed.cell_stress();
    for (auto component : {&CellStress::normal, &CellStress::shear, &CellStress::transverse,
                           &CellStress::lateral_x, &CellStress::lateral_y})
      largest = std::max(largest, std::abs(a.*component - b.*component) / a.mean());
  }
  const CellStress end = exact.cell_stress();
  std::printf("stress differs by %.1e of the mean at most; sigma %.4g, tau %.4g Pa at the end\n", largest, end.normal,
              end.shear);
  EXPECT_LT(largest, 1e-5);  // what the engine promises; rounding of 6e-8 of forces whose sums cancel
  EXPECT_GT(std::abs(end.shear), 1e-3 * end.normal);
}

/// Two glued grains in contact, of which the upper slides slowly over the lower: the spring is all that changes.
Assembly creeping_pair(double spring) {
  Assembly pair;
  pair.cell = cube(0.1, false);
  pair.resize(2);
  pair.radius = {3e-3, 3e-3};
  pair.position = {Vector3::Zero(), Vector3(0.0, 0.0, 6e-3 - 1e-5)};
  pair.role = {Role::bottom_layer, Role::top_layer};
  // Of the lower relative to the upper: the upper goes to +x, the spring of the lower to -x.
  pair.contacts = {{0, 1, {-spring, 0.0, 0.0}, Vector3::Zero()}};
  return pair;
}

/// By how much the spring grows per step, as a share of the way of a step.
template <typename Real>
double growth(double spring, double increment) {
  constexpr double time_step = 1e-6;
  constexpr int steps = 1000;
  NativeEngine<Real> engine;
  engine.load(creeping_pair(spring), {Material{}, time_step, 0.0});
  engine.move({Vector3::Zero(), {increment / time_step, 0.0, 0.0}, 0.0, 0.0});
  engine.run(steps);
  const double now = -engine.save().contacts.at(0).tangential_spring.x();
  return (now - static_cast<Real>(spring)) / (steps * increment);
}

TEST(MixedPrecision, ASpringOfFloatLosesIncrementsBelowHalfAUnitInItsLastPlace) {
  // The bound: v dt < s 2^-24 (s a power of two; up to 2^-25 s above it) is lost at every step and the spring stands
  // still, however long the creep. With s = 1e-6 m, of a contact that carries some 1 N near its cap, and dt = 5e-6 s
  // this is v = 0.01 um/s, or a rate of shear of 2e-6 1/s over a grain. Between one and some tens of units the spring
  // advances in whole units: its rate is wrong by up to half a unit over the increment.
  const double spring = 0x1p-20;  // m, 0.95 um; far below the cap
  const double unit = spring * std::numeric_limits<float>::epsilon();
  for (const double units : {0.25, 0.49, 0.51, 0.75, 1.0, 1.4, 10.3, 100.3, 1000.3}) {
    const double in_float = growth<float>(spring, units * unit), in_double = growth<double>(spring, units * unit);
    std::printf("%7.2f units a step, %.3g m/s at 1 us: grows by %.4f of it, in double by %.6f\n", units,
                units * unit / 1e-6, in_float, in_double);
    EXPECT_NEAR(in_double, 1.0, 1e-6);  // 2e-9 of a unit of float is lost
    if (units < 0.5)
      EXPECT_EQ(in_float, 0.0);
    else
      EXPECT_NEAR(in_float, 1.0, 0.5 / units + 1e-6);
  }
}

TEST(MixedPrecision, ShearAtTheRatesOfThePaperIsFarFromThatBound) {
  // The slowest shear that is computed, 1e-3 1/s over a grain of 6 mm at 5e-6 s, with a spring at its cap under 28 kPa:
  // about 2.5 um.
  const double spring = 2.5e-6, increment = 1e-3 * 6e-3 * 5e-6;
  const double unit = spring * std::numeric_limits<float>::epsilon();
  EXPECT_GT(increment, 50.0 * unit);
  EXPECT_NEAR(growth<float>(0.5 * spring, increment), 1.0, unit / increment);
}

/// Difference of the forces of the last step and those found once more from the saved state, as a share of the largest
/// contact force.
double error_of_rebuilt_forces(const Assembly& now, double time_step, const PlaneVelocities& planes) {
  const ContactForces forces = evaluate_contact_forces(now, Material{}, time_step, planes);
  const GrainForces rebuilt = sum_on_grains(forces, now.size());
  double largest = 0.0, error = 0.0;
  for (const Contact& contact : forces.contacts) largest = std::max(largest, contact.force.on_first.norm());
  for (std::size_t i = 0; i < now.size(); ++i) {
    error = std::max(error, (now.force[i] - rebuilt.force[i]).norm());
    error = std::max(error, (now.torque[i] - rebuilt.torque[i]).norm() / now.radius[i]);
  }
  return error / largest;
}

/// A lattice that shears apart while it flows at 4 m/s: a third of its contacts slide, many of them with a normal force
/// that is a small difference of spring and dashpot.
TEST(MixedPrecision, ForcesOfASavedStateAreThoseOfItsStep) {
  constexpr double time_step = 2e-6, rate = 20.0, speed = 4.0, opening = 0.4;  // s, 1/s, m/s, 1/s
  Assembly start = touching_lattice();
  const double height = start.cell.height();
  for (std::size_t i = 0; i < start.size(); ++i) start.velocity[i].x() += speed + rate * start.position[i].z();
  const BoundaryMotion motion{{speed, 0.0, 0.0}, {speed + rate * height, 0.0, opening * height}, 0.0, 0.0};
  const PlaneVelocities planes{{0.0, 0.0, 0.0}, {0.0, 0.0, opening * height}};
  MixedEngine engine, again;
  engine.load(start, {Material{}, time_step, 0.0});
  engine.move(motion);
  double largest = 0.0;
  std::size_t sliding = 0, rolling = 0, all = 0;
  for (int part = 0; part < 20; ++part) {
    engine.run(100);
    const Assembly now = engine.save();
    again.load(now, engine.settings());
    for (const Assembly& saved : {now, again.save()})
      largest = std::max(largest, error_of_rebuilt_forces(saved, time_step, planes));
    for (const ContactHistory& contact : now.contacts) {
      sliding += contact.spring_cap == Cap::reached;
      rolling += contact.torque_cap == Cap::reached;
      ++all;
    }
  }
  std::printf("forces differ by %.1e of the largest contact force; %zu of %zu contacts slide, %zu roll\n", largest,
              sliding, all, rolling);
  EXPECT_LT(largest, 1e-5);  // a contact on the wrong side of its cap makes 1e-3 and more
  EXPECT_GT(sliding, all / 10);
  EXPECT_GT(rolling, all / 100);
  EXPECT_LT(sliding, all / 2);
}

}  // namespace
}  // namespace flowslide
