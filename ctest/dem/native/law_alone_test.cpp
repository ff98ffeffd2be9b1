// SPDX-License-Identifier: GPL-2.0-or-later
// The law through the native engine, two or three grains at a time, against closed forms.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "dem/native/native_engine.hpp"
#include "grains/contact_forces.hpp"
#include "grains/pair_constants.hpp"
#include "support/clustered_cloud.hpp"

namespace flowslide::law_alone_test {
namespace {

constexpr double radius_first = 3e-3, radius_second = 2e-3;  // m

Material material(double restitution, double sliding, double rolling) {
  Material m;
  m.restitution = restitution;
  m.sliding_friction = sliding;
  m.rolling_friction = rolling;
  return m;
}

/// Two grains along an oblique line, overlapping by `overlap` (m).
Assembly two_grains(double overlap) {
  Assembly pair;
  pair.cell = cube(0.1, false);
  pair.resize(2);
  pair.radius = {radius_first, radius_second};
  const Vector3 normal = Vector3(1.0, -2.0, 0.5).normalized();
  pair.position = {Vector3(1e-3, 2e-3, -1e-3), Vector3(1e-3, 2e-3, -1e-3)};
  pair.position[1] -= (radius_first + radius_second - overlap) * normal;
  return pair;
}

Vector3 normal_of(const Assembly& pair) { return (pair.position[0] - pair.position[1]).normalized(); }
double overlap_of(const Assembly& pair) {
  return pair.radius[0] + pair.radius[1] - (pair.position[0] - pair.position[1]).norm();
}
double separation_speed(const Assembly& pair) { return (pair.velocity[0] - pair.velocity[1]).dot(normal_of(pair)); }

/// Largest overlap (m) and contact time (s) of an undamped Hertz impact at `speed` (m/s), in closed form.
struct Hertz {
  Hertz(const PairConstants& pair, double speed) {
    overlap = std::pow(
        15.0 * pair.effective_mass * speed * speed / (16.0 * std::sqrt(pair.effective_radius) * pair.effective_modulus),
        0.4);
    // 2 int_0^1 dx / sqrt(1 - x^(5/2)) = (4/5) sqrt(pi) Gamma(2/5) / Gamma(9/10)
    time = 0.8 * std::sqrt(std::numbers::pi) * std::tgamma(0.4) / std::tgamma(0.9) * overlap / speed;
  }
  double overlap, time;
};

/// The impact of two grains that just touch and approach at `speed`, step by step until they part.
struct Impact {
  Assembly after;
  double largest_overlap = 0.0, time = 0.0;
};

Impact impact(const Material& m, double speed, double time_step) {
  DoubleEngine engine;
  Assembly pair = two_grains(0.0);
  pair.velocity[0] = -0.25 * speed * normal_of(pair);
  pair.velocity[1] = 0.75 * speed * normal_of(pair);
  engine.load(pair, {m, time_step, 0.0});
  Impact result;
  double before = 0.0;
  for (int step = 1; step < 100000; ++step) {
    engine.run(1);
    result.after = engine.save();
    const double overlap = overlap_of(result.after);
    result.largest_overlap = std::max(result.largest_overlap, overlap);
    result.time = (step - 1 + before / (before - overlap)) * time_step;  // where a line through the two steps ends
    if (step > 1 && overlap < 0.0) break;
    before = overlap;
  }
  engine.run(10);  // the dashpot does not pull after separation
  result.after = engine.save();
  return result;
}

TEST(LawAlone, NormalImpactReturnsTheCoefficientOfRestitution) {
  for (const double speed : {0.01, 0.2, 2.0}) {
    const Hertz hertz(pair_constants(Material{}, radius_first, radius_second), speed);
    const Impact result = impact(material(0.8, 0.0, 0.0), speed, hertz.time / 4000);
    std::printf("restitution at %g m/s: %.6f\n", speed, separation_speed(result.after) / speed);
    // First order in dt: 1/4000 of the contact leaves less than 1e-3.
    EXPECT_NEAR(separation_speed(result.after) / speed, 0.8, 1e-3) << speed;
  }
}

TEST(LawAlone, UndampedImpactLastsAndOverlapsAsHertzSays) {
  for (const double speed : {0.01, 0.2, 2.0}) {
    const Hertz hertz(pair_constants(Material{}, radius_first, radius_second), speed);
    const Impact result = impact(material(1.0, 0.0, 0.0), speed, hertz.time / 4000);
    std::printf("at %g m/s: contact time %.1e, largest overlap %.1e off\n", speed, result.time / hertz.time - 1.0,
                result.largest_overlap / hertz.overlap - 1.0);
    // Second order in dt: some (1/4000)^2; the sampling of the largest overlap is of the same order.
    EXPECT_NEAR(result.time / hertz.time, 1.0, 1e-5) << speed;
    EXPECT_NEAR(result.largest_overlap / hertz.overlap, 1.0, 1e-5) << speed;
    EXPECT_NEAR(separation_speed(result.after) / speed, 1.0, 1e-5) << speed;
  }
}

TEST(LawAlone, ObliqueImpactKeepsMomentumAndAngularMomentum) {
  const Material m;
  Assembly pair = two_grains(0.0);
  pair.velocity = {-0.3 * normal_of(pair) + Vector3(0.1, 0.2, 0.3), Vector3(-0.1, 0.3, 0.05)};
  pair.spin = {Vector3(20.0, -30.0, 40.0), Vector3(-10.0, 5.0, 60.0)};
  const auto momentum = [&](const Assembly& a, Vector3& angular) {
    Vector3 linear = Vector3::Zero();
    angular.setZero();
    for (std::size_t i = 0; i < 2; ++i) {
      const double mass = sphere_mass(a.radius[i], m);
      linear += mass * a.velocity[i];
      angular += mass * a.position[i].cross(a.velocity[i]) + sphere_inertia(a.radius[i], m) * a.spin[i];
    }
    return linear;
  };
  Vector3 angular_before, angular_after;
  const Vector3 before = momentum(pair, angular_before);
  DoubleEngine engine;
  engine.load(pair, {m, 1e-7, 0.0});
  engine.run(2000);
  const Assembly after = engine.save();
  ASSERT_LT(overlap_of(after), 0.0);
  EXPECT_GT((after.spin[0] - pair.spin[0]).norm(), 1.0);  // friction has acted
  // Rounding of some 1000 sums: the lever arms add up to the distance of the centres, so nothing else is lost.
  EXPECT_LT((momentum(after, angular_after) - before).norm(), 1e-13 * before.norm());
  EXPECT_LT((angular_after - angular_before).norm(), 1e-12 * angular_before.norm());
}

/// Glued, mobile and glued grain in a column, each pair overlapping by `overlap`: the one in the middle may only spin.
Assembly column(double overlap, const Vector3& spin) {
  Assembly grains;
  grains.cell = cube(0.05, false);
  grains.resize(3);
  grains.radius = {2e-3, 3e-3, 2e-3};
  for (int i = 0; i < 3; ++i) grains.position[i] = Vector3(0.0, 0.0, (i - 1) * (5e-3 - overlap));
  grains.role = {Role::bottom_layer, Role::mobile, Role::top_layer};
  grains.spin[1] = spin;
  return grains;
}

/// Expects the damped oscillation of the spin about `axis` below the cap, to the first order of the scheme.
void expect_damped_oscillation(const Material& m, const Vector3& axis) {
  const double overlap = 1e-5, start = 1e-3;  // m, rad/s
  const PairConstants pair = pair_constants(m, 3e-3, 2e-3);
  const double kn = 4.0 / 3.0 * pair.effective_modulus * std::sqrt(pair.effective_radius * overlap);
  const double kr = m.rolling_stiffness * kn * std::pow(m.rolling_friction * pair.effective_radius, 2);
  const double dashpot = 2.0 * m.rolling_viscous_damping * std::sqrt(pair.rolling_inertia * kr);
  const double inertia = sphere_inertia(3e-3, m);
  // Two contacts: I w' = -2 (M + c w), M' = k_r w.
  const double frequency = std::sqrt(2.0 * kr / inertia), ratio = dashpot / (inertia * frequency);
  ASSERT_LT(ratio, 1.0);
  const double damped = frequency * std::sqrt(1.0 - ratio * ratio);
  const double period = 2.0 * std::numbers::pi / damped;
  const auto error_at = [&](int steps_in_period) {
    const double time_step = period / steps_in_period;
    DoubleEngine engine;
    engine.load(column(overlap, start * axis), {m, time_step, 0.0});
    double error = 0.0;
    for (int part = 1; part <= 16; ++part) {
      engine.run(steps_in_period / 8);
      const double t = part * (steps_in_period / 8) * time_step;
      const double spin = start * std::exp(-ratio * frequency * t) *
                          (std::cos(damped * t) - ratio * frequency / damped * std::sin(damped * t));
      error = std::max(error, std::abs(engine.save().spin[1].dot(axis) - spin) / start);
    }
    return error;
  };
  const double coarse = error_at(4000), fine = error_at(8000);
  std::printf("error %.2g, at half the step %.2g\n", coarse, fine);
  EXPECT_LT(coarse, 2e-3);  // first order: 2 pi / 4000 of the period
  EXPECT_NEAR(coarse / fine, 2.0, 0.1);
}

TEST(LawAlone, RollingBelowItsCapIsADampedOscillator) {
  expect_damped_oscillation(material(0.8, 0.0, 0.1), Vector3::UnitX());
}

TEST(LawAlone, ResistedTorsionBelowItsCapIsTheSameOscillator) {
  Material m = material(0.8, 0.5, 0.1);  // friction does not act on a twist
  m.torsion_resistance = true;
  expect_damped_oscillation(m, Vector3::UnitZ());
}

/// Above its cap the torque is constant. Then the spring brings the grain to rest.
void expect_even_slowing_to_rest(const Material& m, const Vector3& axis) {
  const double overlap = 1e-5, time_step = 1e-7;
  const PairConstants pair = pair_constants(m, 3e-3, 2e-3);
  const double slope = 2.0 * m.rolling_friction * normal_force(m, pair, overlap, 0.0) * pair.effective_radius /
                       sphere_inertia(3e-3, m);  // rad/s^2
  DoubleEngine engine;
  engine.load(column(overlap, 3000.0 * axis), {m, time_step, 0.0});
  engine.run(1000);  // the spring has reached its cap
  const double first = engine.save().spin[1].dot(axis);
  engine.run(5000);
  const double second = engine.save().spin[1].dot(axis);
  ASSERT_GT(second, 20.0);
  EXPECT_NEAR((first - second) / (5000 * time_step) / slope, 1.0, 1e-9);  // overlap rounds to 1e-18 of 1e-5 m
  engine.set({m, 1e-6, 0.0});
  engine.run(100000);  // 8.5 ms to stop, then 0.09 s of an oscillation that loses a factor e in 2.8 ms
  EXPECT_LT(engine.save().spin[1].norm(), 1e-9);
}

TEST(LawAlone, RollingAtItsCapSlowsEvenlyAndThenComesToRest) {
  expect_even_slowing_to_rest(material(0.8, 0.0, 0.1), Vector3::UnitX());
}

TEST(LawAlone, ResistedTorsionAtItsCapSlowsEvenlyAndThenComesToRest) {
  Material m = material(0.8, 0.0, 0.1);
  m.torsion_resistance = true;
  expect_even_slowing_to_rest(m, Vector3::UnitZ());
}

TEST(LawAlone, ALimitedNormalForceDoesNotHoldGrainsThatPart) {
  Material m = material(0.3, 0.5, 0.1);
  const double speed = 5.0;  // m/s: the dashpot exceeds the spring
  Assembly pair = two_grains(2e-5);
  pair.velocity[0] = speed * normal_of(pair);
  const Vector3 start = pair.velocity[0];
  for (const bool limited : {false, true}) {
    m.normal_force_limited = limited;
    DoubleEngine engine;
    engine.load(pair, {m, 1e-8, 0.0});
    engine.run(100);
    const Assembly after = engine.save();
    ASSERT_GT(overlap_of(after), 1e-5);
    if (limited)
      EXPECT_EQ(after.velocity[0], start);
    else
      EXPECT_LT(separation_speed(after), 0.99 * speed);
  }
}

TEST(LawAlone, SlidingSurfaceSlowsEvenlyByCoulombAndTwistingIsFree) {
  const Material m = material(0.8, 0.5, 0.0);
  const double overlap = 1e-5, time_step = 1e-7;
  const double force = normal_force(m, pair_constants(m, 3e-3, 2e-3), overlap, 0.0);
  const double slope = 2.0 * m.sliding_friction * force * (3e-3 - 0.5 * overlap) / sphere_inertia(3e-3, m);
  DoubleEngine engine;
  engine.load(column(overlap, {0.0, 2000.0, 50.0}), {m, time_step, 0.0});
  engine.run(200);
  const double first = engine.save().spin[1].y();
  engine.run(300);
  const Assembly after = engine.save();
  ASSERT_GT(after.spin[1].y(), 20.0);
  EXPECT_NEAR((first - after.spin[1].y()) / (300 * time_step) / slope, 1.0, 1e-9);
  EXPECT_EQ(after.spin[1].z(), 50.0);  // no torque about the normal
}

/// Where two overlapping grains are after a fixed time in `steps` steps. They start with the forces of their state.
double position_after(const Material& m, int steps) {
  Assembly pair = two_grains(2e-5);
  const GrainForces forces = sum_on_grains(evaluate_contact_forces(pair, m, 0.0), 2);
  pair.force = forces.force;
  DoubleEngine engine;
  engine.load(pair, {m, 8e-6 / steps, 0.0});
  engine.run(steps);
  EXPECT_GT(overlap_of(engine.save()), 1e-6);  // still in touch: parting is not smooth
  return overlap_of(engine.save());
}

TEST(LawAlone, IsSecondOrderWithoutDashpotsAndFirstOrderWithThem) {
  const auto order = [](const Material& m) {
    const double coarse = position_after(m, 20), middle = position_after(m, 40), fine = position_after(m, 80);
    return std::log2((coarse - middle) / (middle - fine));
  };
  const double without = order(material(1.0, 0.0, 0.0)), with = order(material(0.8, 0.0, 0.0));
  std::printf("order without dashpots %.3f, with %.3f\n", without, with);
  // The dashpots see the velocities of the half step. A tenth: the next order at 20 to 80 steps.
  EXPECT_NEAR(without, 2.0, 0.1);
  EXPECT_NEAR(with, 1.0, 0.1);
}

}  // namespace
}  // namespace flowslide::law_alone_test
