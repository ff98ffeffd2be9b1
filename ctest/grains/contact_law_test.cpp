// SPDX-License-Identifier: GPL-2.0-or-later
#include "grains/contact_law.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>

#include "hertz_contact_time.hpp"
#include "random_assembly.hpp"
#include "support/contact_switches.hpp"

namespace flowslide::contact_law_test {
namespace {

constexpr double rounding = 1e-13;  // of hand-made numbers of order one
const Vector3 zero = Vector3::Zero(), x = Vector3::UnitX(), y = Vector3::UnitY(), z = Vector3::UnitZ();

/// Numbers that can be followed by hand. Two spheres of R = 2 m, overlap 1/4: R* = 1, sqrt(R* delta) = 1/2, lever 15/8.
/// E = 6, nu = 0: Y* = 3, G* = 3/4; k_n = 2, S_n = 3, k_t = S_t = 3, elastic F_n = 1/2. m* = 5/4 and e = exp(-pi), that
/// is beta = -1/sqrt(2): gamma_n = gamma_t = 2 sqrt(5/6 * 1/2 * 3 * 5/4) = 5/2. I_r = 7/10 * (5/2 * 4) = 7.
class ContactLaw : public ::testing::Test {
 protected:
  ContactLaw() {
    material.youngs_modulus = 6.0;
    material.poisson_ratio = 0.0;
    material.restitution = std::exp(-std::numbers::pi);
    material.density = 2.5 / (4.0 / 3.0 * std::numbers::pi * 8.0);
    material.sliding_friction = 0.5;
    material.rolling_friction = 0.5;   // k_r = 1 * 2 * 1/4 = 1/2, elastic cap 1/4
    material.rolling_stiffness = 1.0;
    material.rolling_viscous_damping = 0.5;  // times 2 sqrt(7 * 1/2)
    motion.overlap = 0.25;
  }
  ContactForce step(const Vector3& spring, const Vector3& rolling, double time_step) const {
    return step_contact(material, pair_constants(material, 2.0, 2.0), motion, {{spring}, {rolling}}, time_step);
  }
  ContactForce stored(const Vector3& spring, const Vector3& rolling) const {
    return stored_contact(material, pair_constants(material, 2.0, 2.0), motion, {{spring}, {rolling}});
  }
  Material material;
  ContactKinematics motion;
};

void expect_near(const Vector3& value, const Vector3& expected, double tolerance) {
  EXPECT_LE((value - expected).cwiseAbs().maxCoeff(), tolerance)
      << "value " << value.transpose() << ", expected " << expected.transpose();
}

TEST_F(ContactLaw, NormalForceIsHertzPlusDashpot) {
  EXPECT_NEAR(step(zero, zero, 1.0).normal, 0.5, rounding);
  motion.relative_velocity = -0.1 * x;  // approaching
  EXPECT_NEAR(step(zero, zero, 1.0).normal, 0.75, rounding);
  expect_near(step(zero, zero, 1.0).on_first, 0.75 * x, rounding);
  motion.relative_velocity = 1.0 * x;  // separating fast: not clipped at zero
  EXPECT_NEAR(step(zero, zero, 1.0).normal, -2.0, rounding);
  motion.normal = -z;
  motion.relative_velocity = 0.1 * z;  // approaching along the other axis
  expect_near(step(zero, zero, 1.0).on_first, -0.75 * z, rounding);
}

TEST_F(ContactLaw, ALimitedNormalForceIsZeroWhereTheDashpotWouldPull) {
  material.normal_force_limited = true;
  motion.relative_velocity = 0.1 * x;  // the spring exceeds the dashpot
  EXPECT_NEAR(step(zero, zero, 1.0).normal, 0.25, rounding);
  motion.relative_velocity = 1.0 * x + 0.1 * y;
  const ContactForce force = step(0.01 * y, 0.1 * z, 1.0);
  EXPECT_EQ(force.normal, 0.0);
  expect_near(force.on_first, zero, rounding);  // the caps are 0 as well
  expect_near(force.tangential_spring, zero, rounding);
  expect_near(force.torque_on_first, zero, rounding);
  expect_near(force.rolling_torque, zero, rounding);
  motion.relative_velocity.x() = std::nan("");
  EXPECT_TRUE(std::isnan(step(zero, zero, 1.0).normal));
}

TEST_F(ContactLaw, HertzForceGrowsWithThePowerThreeHalves) {
  const PairConstants pair = pair_constants(material, 2.0, 2.0);
  EXPECT_NEAR(normal_force(material, pair, 0.04, 0.0) / normal_force(material, pair, 0.01, 0.0), 8.0, rounding);
}

TEST_F(ContactLaw, TangentialSpringAndDashpotOpposeTheSliding) {
  motion.relative_velocity = 0.01 * y;
  const ContactForce force = step(zero, zero, 2.0);
  // s = 0.02; F_t = -3 * 0.02 - 5/2 * 0.01, below the cap of 1/4.
  EXPECT_FALSE(force.sliding);
  expect_near(force.tangential_spring, 0.02 * y, rounding);
  expect_near(force.on_first, 0.5 * x - 0.085 * y, rounding);
  // -15/8 x (x) (-0.085 y) on both.
  expect_near(force.torque_on_first, 0.159375 * z, rounding);
  expect_near(force.torque_on_second, 0.159375 * z, rounding);
}

TEST_F(ContactLaw, SpringBuildsUpFromItsHistory) {
  motion.relative_velocity = 0.01 * y;
  const ContactForce first = step(zero, zero, 1.0);
  const ContactForce second = step(first.tangential_spring, zero, 1.0);
  expect_near(second.tangential_spring, 0.02 * y, rounding);
  motion.relative_velocity = zero;
  expect_near(step(second.tangential_spring, zero, 1.0).on_first, 0.5 * x - 0.06 * y, rounding);
}

TEST_F(ContactLaw, SpinsMoveTheSurfaces) {
  material.rolling_friction = 0.0;
  motion.spin_first = 0.008 * z;
  motion.spin_second = 0.008 * z;
  // Both surfaces: v_t = -(15/8 + 15/8) 0.008 z (x) x = -0.03 y.
  expect_near(step(zero, zero, 1.0).tangential_spring, -0.03 * y, rounding);
  motion.spin_second = -0.008 * z;  // rolls without sliding
  expect_near(step(zero, zero, 1.0).tangential_spring, zero, rounding);
}

TEST_F(ContactLaw, CoulombCapScalesSpringAndDropsTheDashpot) {
  motion.relative_velocity = 0.3 * y + 0.4 * z;
  const ContactForce force = step(zero, zero, 1.0);
  EXPECT_TRUE(force.sliding);
  expect_near(force.on_first, 0.5 * x - 0.15 * y - 0.2 * z, rounding);  // 1/2 of F_n, against the sliding
  expect_near(force.tangential_spring, 0.05 * y + 0.2 / 3.0 * z, rounding);
}

TEST_F(ContactLaw, CoulombCapTakesTheDashpotOfTheNormalForce) {
  motion.relative_velocity = -0.1 * x + 1.0 * y;  // F_n = 3/4
  expect_near(step(zero, zero, 1.0).on_first, 0.75 * x - 0.375 * y, rounding);
  motion.relative_velocity = 0.4 * x + 1.0 * y;   // F_n = -1/2: the cap takes its magnitude
  expect_near(step(zero, zero, 1.0).on_first, -0.5 * x - 0.25 * y, rounding);
}

TEST_F(ContactLaw, WithoutFrictionNothingIsTangential) {
  material.sliding_friction = material.rolling_friction = 0.0;
  motion.relative_velocity = 0.1 * y;
  motion.spin_first = z;
  const ContactForce force = step(0.01 * y, 0.01 * z, 1.0);
  expect_near(force.on_first, 0.5 * x, rounding);
  EXPECT_EQ(force.tangential_spring, zero);
  EXPECT_EQ(force.torque_on_first, zero);
  EXPECT_EQ(force.torque_on_second, zero);
  EXPECT_EQ(force.rolling_torque, zero);
}

TEST_F(ContactLaw, SpringIsProjectedOnTheTangentPlane) {
  const ContactForce force = step(Vector3(0.05, 0.02, -0.01), zero, 1.0);
  expect_near(force.tangential_spring, Vector3(0.0, 0.02, -0.01), rounding);  // not scaled back to its length
}

TEST_F(ContactLaw, RollingSpringAndDashpotOpposeTheRolling) {
  motion.spin_first = 0.02 * z;
  motion.spin_second = -0.02 * z;  // no sliding
  const ContactForce force = step(zero, zero, 3.0);
  EXPECT_FALSE(force.rolling);
  expect_near(force.rolling_torque, 0.5 * 0.04 * 3.0 * z, rounding);
  const double dashpot = 0.5 * 2.0 * std::sqrt(3.5) * 0.04;
  expect_near(force.torque_on_first, -(0.06 + dashpot) * z, rounding);
  expect_near(force.torque_on_second, (0.06 + dashpot) * z, rounding);
}

TEST_F(ContactLaw, RollingCapScalesTorqueAndDropsTheDashpot) {
  motion.spin_first = 0.02 * z;
  motion.spin_second = -0.02 * z;
  const ContactForce force = step(zero, 0.3 * y, 20.0);  // 0.3 y + 0.4 z, cap 1/2 * 1/2 * 1
  EXPECT_TRUE(force.rolling);
  expect_near(force.rolling_torque, 0.15 * y + 0.2 * z, rounding);
  expect_near(force.torque_on_first, -0.15 * y - 0.2 * z, rounding);
}

TEST_F(ContactLaw, TorsionHasNoTorqueAndStoredTorqueIsNotProjected) {
  motion.spin_first = 3.0 * x;
  EXPECT_EQ(step(zero, zero, 1.0).rolling_torque, zero);
  expect_near(step(zero, 0.1 * x, 1.0).rolling_torque, 0.1 * x, rounding);
}

TEST_F(ContactLaw, ResistedTorsionActsAsRolling) {
  material.torsion_resistance = true;
  motion.spin_first = 0.02 * x + 0.02 * z;
  motion.spin_second = -0.02 * x - 0.02 * z;
  const ContactForce force = step(zero, zero, 3.0);
  EXPECT_FALSE(force.rolling);
  expect_near(force.rolling_torque, 0.06 * (x + z), rounding);
  const double dashpot = 0.5 * 2.0 * std::sqrt(3.5) * 0.04;
  expect_near(force.torque_on_second, (0.06 + dashpot) * (x + z), rounding);
  EXPECT_TRUE(step(zero, 0.3 * x, 1.0).rolling);  // one cap of 1/4 for both
}

TEST_F(ContactLaw, AStoredHistoryIsAtItsCapWhereItsEngineSaysSo) {
  motion.relative_velocity = 0.01 * y;
  const auto known = [&](double length, Cap cap) {
    return stored_contact(material, pair_constants(material, 2.0, 2.0), motion,
                          {{length / 3.0 * y, cap}, {length * z, cap}});
  };
  // F_n of the engine was larger by 1e-5 than ours of 1/2, so that its caps of 1/4 were, or smaller.
  for (const double length : {0.25 * (1.0 + 1e-5), 0.25 * (1.0 - 1e-5)}) {
    const ContactForce capped = known(length, Cap::reached), below = known(length, Cap::below);
    EXPECT_TRUE(capped.sliding && capped.rolling);
    EXPECT_FALSE(below.sliding || below.rolling);
    expect_near(capped.on_first, 0.5 * x - length * y, rounding);
    expect_near(below.on_first, 0.5 * x - (length + 2.5 * 0.01) * y, rounding);  // and its dashpot
  }
}

TEST_F(ContactLaw, ForceOfAStoredHistory) {
  motion.relative_velocity = 0.01 * y;
  ContactForce force = stored(0.02 * y + 0.03 * z, 0.1 * z);
  // -3 s - 5/2 v_t below the cap of 1/4; nothing advances.
  EXPECT_FALSE(force.sliding);
  expect_near(force.on_first, 0.5 * x - 0.085 * y - 0.09 * z, rounding);
  EXPECT_EQ(force.tangential_spring, Vector3(0.02 * y + 0.03 * z));
  EXPECT_EQ(force.rolling_torque, Vector3(0.1 * z));
  force = stored(0.25 / 3.0 * (1.0 - 1e-7) * y, 0.25 * (1.0 - 1e-7) * z);  // at both caps: no dashpots
  EXPECT_TRUE(force.sliding);
  EXPECT_TRUE(force.rolling);
  expect_near(force.on_first, 0.5 * x - 0.25 * y, 1e-7);
  force = stored(0.25 / 3.0 * (1.0 - 1e-5) * y, 0.25 * (1.0 - 1e-5) * z);
  EXPECT_FALSE(force.sliding);
  EXPECT_FALSE(force.rolling);
  force = stored(1.0 * y, 1.0 * z);  // beyond both: the caps act
  expect_near(force.on_first, 0.5 * x - 0.25 * y, rounding);
  // 15/8 * 1/4 z from the friction, -1/4 z from rolling.
  expect_near(force.torque_on_first, (0.46875 - 0.25) * z, rounding);
}

/// A random contact of Table 1's material; springs from far below to far above their caps.
struct RandomContact {
  explicit RandomContact(std::mt19937_64& generator) {
    using testing::uniform;
    using testing::uniform_vector;
    material = with_all_switches({})[generator() % 4];
    pair = pair_constants(material, uniform(generator, 2.5e-3, 3.75e-3), uniform(generator, 2.5e-3, 3.75e-3));
    motion.normal = uniform_vector(generator, 1.0).normalized();
    motion.overlap = std::pow(10.0, uniform(generator, -9.0, -4.5));
    motion.relative_velocity = uniform_vector(generator, 1e-2);
    motion.spin_first = uniform_vector(generator, 5.0);
    motion.spin_second = uniform_vector(generator, 5.0);
    spring = uniform_vector(generator, motion.overlap);
    spring -= spring.dot(motion.normal) * motion.normal;
    const double cap = 0.1 * pair.effective_radius * normal_force(material, pair, motion.overlap, 0.0);
    rolling = uniform_vector(generator, cap);
  }
  ContactForce evaluate(bool advance) const {
    const ContactHistories histories{{spring}, {rolling}};
    return advance ? step_contact(material, pair, motion, histories, 5e-7)
                   : stored_contact(material, pair, motion, histories);
  }
  Material material;
  PairConstants pair;
  ContactKinematics motion;
  Vector3 spring, rolling;
};

TEST(ContactLawInvariants, StoredHistoryReproducesTheStepThatMadeIt) {
  std::mt19937_64 generator(1);
  int sliding = 0, rolling = 0;
  for (int k = 0; k < 1000; ++k) {
    RandomContact contact(generator);
    const ContactForce step = contact.evaluate(true);
    contact.spring = step.tangential_spring;
    contact.rolling = step.rolling_torque;
    const ContactForce again = contact.evaluate(false);
    const double size = step.on_first.norm();
    expect_near(again.on_first, step.on_first, 1e-13 * size);
    expect_near(again.torque_on_first, step.torque_on_first, 1e-15 * size);  // lever arms of some mm
    expect_near(again.torque_on_second, step.torque_on_second, 1e-15 * size);
    EXPECT_EQ(again.sliding, step.sliding);
    EXPECT_EQ(again.rolling, step.rolling);
    sliding += step.sliding;
    rolling += step.rolling;
  }
  // Both branches of both caps were met.
  EXPECT_GT(sliding, 100);
  EXPECT_LT(sliding, 900);
  EXPECT_GT(rolling, 100);
  EXPECT_LT(rolling, 900);
}

TEST(ContactLawInvariants, AngularMomentumIsConserved) {
  std::mt19937_64 generator(2);
  for (int k = 0; k < 100; ++k) {
    const RandomContact contact(generator);
    const ContactForce force = contact.evaluate(true);
    const double distance = contact.pair.radius_first + contact.pair.radius_second - contact.motion.overlap;
    const Vector3 moment = (distance * contact.motion.normal).cross(force.on_first);
    expect_near(moment + force.torque_on_first + force.torque_on_second, zero, 1e-15 * force.on_first.norm());
  }
}

TEST(ContactLawInvariants, ExchangeOfTheSpheresTurnsTheForce) {
  std::mt19937_64 generator(3);
  for (int k = 0; k < 100; ++k) {
    const RandomContact contact(generator);
    RandomContact other = contact;
    std::swap(other.pair.radius_first, other.pair.radius_second);
    std::swap(other.motion.spin_first, other.motion.spin_second);
    other.motion.normal = -contact.motion.normal;
    other.motion.relative_velocity = -contact.motion.relative_velocity;
    other.spring = -contact.spring;
    other.rolling = -contact.rolling;
    const ContactForce force = contact.evaluate(true), turned = other.evaluate(true);
    const double size = force.on_first.norm();
    expect_near(turned.on_first, -force.on_first, 1e-13 * size);
    expect_near(turned.torque_on_first, force.torque_on_second, 1e-15 * size);
    expect_near(turned.torque_on_second, force.torque_on_first, 1e-15 * size);
  }
}

TEST(ContactLawInvariants, RotatedContactHasTheRotatedForce) {
  std::mt19937_64 generator(4);
  for (int k = 0; k < 100; ++k) {
    const RandomContact contact(generator);
    const Matrix3 turn =
        Eigen::AngleAxisd(testing::uniform(generator, 0.0, 6.0), testing::uniform_vector(generator, 1.0).normalized())
            .toRotationMatrix();
    RandomContact turned = contact;
    for (Vector3* vector : {&turned.motion.normal, &turned.motion.relative_velocity, &turned.motion.spin_first,
                            &turned.motion.spin_second, &turned.spring, &turned.rolling})
      *vector = turn * *vector;
    const ContactForce force = contact.evaluate(true);
    expect_near(turned.evaluate(true).on_first, turn * force.on_first, 1e-13 * force.on_first.norm());
    expect_near(turned.evaluate(true).torque_on_second, turn * force.torque_on_second, 1e-15 * force.on_first.norm());
  }
}

struct Impact {
  double duration, largest_overlap, restitution;
};

/// Head-on impact with the reduced mass and `normal(overlap, separation velocity)`, by velocity Verlet with the force
/// at the velocity of the half step, as the engines do. The end is interpolated where the overlap passes zero.
template <class Normal>
Impact collide(Normal normal, double mass, double speed, double time_step) {
  double overlap = 0.0, velocity = speed, force = 0.0, time = 0.0, largest = 0.0;  // velocity: of approach
  while (true) {
    const double half = velocity - 0.5 * time_step * force / mass;
    const double next = overlap + time_step * half;
    if (next < 0.0) return {time + time_step * overlap / (overlap - next), largest, -half / speed};
    overlap = next;
    force = normal(overlap, -half);
    velocity = half - 0.5 * time_step * force / mass;
    time += time_step;
    largest = std::max(largest, overlap);
  }
}

TEST(Impact, WithoutDampingFollowsHertz) {
  Material material;
  material.restitution = 1.0;
  const double radius = 3e-3, speed = 0.05;
  const PairConstants pair = pair_constants(material, radius, radius);
  const auto normal = [&](double overlap, double velocity) { return normal_force(material, pair, overlap, velocity); };
  const double duration = testing::hertz_contact_time(radius, material, speed);
  const Impact impact = collide(normal, pair.effective_mass, speed, duration / 20000);
  // Second order: (1/20000)^2 and the like; 1e-4 leaves room for the corner of the force at first touch.
  EXPECT_NEAR(impact.duration, duration, 1e-4 * duration);
  const double overlap = hertz_impact_overlap(radius, material, speed);
  EXPECT_NEAR(impact.largest_overlap, overlap, 1e-4 * overlap);
  EXPECT_NEAR(impact.restitution, 1.0, 1e-4);
}

TEST(Impact, OfTwoSpheresReturnsTheCoefficientOfRestitutionAtAnyVelocity) {
  // Exact in the limit of small steps: in y = delta^(5/4) the law is a linear oscillator with the damping ratio |beta|.
  // The half-step dashpot makes the integration first order: some 1/20000.
  for (const double restitution : {0.8, 0.3})
    for (const double speed : {1e-3, 0.5}) {
      Material material;
      material.restitution = restitution;
      const PairConstants pair = pair_constants(material, 2.5e-3, 3.75e-3);
      const auto normal = [&](double overlap, double velocity) {
        return normal_force(material, pair, overlap, velocity);
      };
      const double time_step = testing::hertz_contact_time(3e-3, material, speed) / 20000;
      EXPECT_NEAR(collide(normal, pair.effective_mass, speed, time_step).restitution, restitution, 1e-3);
    }
}

TEST(Impact, OnAPlaneReturnsTheCoefficientOfRestitution) {
  const Material material;
  const double radius = 3e-3, speed = 0.05, mass = sphere_mass(radius, material);
  const auto normal = [&](double overlap, double velocity) {
    return plane_normal_force(material, radius, mass, overlap, -velocity);
  };
  const double time_step = testing::hertz_contact_time(radius, material, speed) / 20000;
  EXPECT_NEAR(collide(normal, mass, speed, time_step).restitution, 0.8, 1e-3);
}

TEST(PlaneNormalForce, IsThatOfASphereOfHalfTheCurvature) {
  // R = 1, overlap 1/4, E = 6, nu = 0: k_n = 4/3 * 3 * 1/2 = 2, S_n = 3; mass 5/4 gives gamma_n = 5/2 as above.
  Material material;
  material.youngs_modulus = 6.0;
  material.poisson_ratio = 0.0;
  material.restitution = std::exp(-std::numbers::pi);
  EXPECT_NEAR(plane_normal_force(material, 1.0, 1.25, 0.25, 0.0), 0.5, rounding);
  EXPECT_NEAR(plane_normal_force(material, 1.0, 1.25, 0.25, 0.1), 0.75, rounding);
  EXPECT_NEAR(plane_normal_force(material, 1.0, 1.25, 0.25, -1.0), -2.0, rounding);
}

}  // namespace
}  // namespace flowslide::contact_law_test
