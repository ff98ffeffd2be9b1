// SPDX-License-Identifier: GPL-2.0-or-later
// core/grains/laws/linear.hpp: the contact law "linear" on each engine, against closed forms of two spheres.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "dem/make_engine.hpp"
#include "grains/contact_law.hpp"
#include "process/mpi_session.hpp"
#include "support/clustered_cloud.hpp"

namespace flowslide {
namespace {

constexpr double radius = 3e-3;  // m
constexpr double pi = std::numbers::pi;

Material linear(double restitution, double friction) {
  Material material;
  material.contact_law = contact_law_of("linear");
  material.restitution = restitution;
  material.sliding_friction = friction;
  material.rolling_friction = 0.0;
  return material;
}

/// m* and k_n by the formula of LIGGGHTS, written out for equal spheres and v_c = 1 m/s.
struct EqualSpheres {
  double mass = 0.5 * 2650.0 * 4.0 / 3.0 * pi * radius * radius * radius;
  double modulus = 2e9 / (2.0 * (1.0 - 0.25 * 0.25));
  double stiffness = 16.0 / 15.0 * std::sqrt(radius / 2.0) * modulus *
                     std::pow(15.0 * mass / (16.0 * std::sqrt(radius / 2.0) * modulus), 0.2);
  double frequency = std::sqrt(stiffness / mass);  ///< rad/s
};

struct Impact {
  Assembly after;
  double time = 0.0, largest_overlap = 0.0;
};

/// The first sphere hits the second, both of the same size: `normal` and `across` are half of their relative velocity,
/// m/s. The step is 1/4000 of an undamped impact.
Impact collide(Engine& engine, const Material& material, double normal, double across) {
  Assembly pair;
  pair.cell = cube(0.2, false);
  pair.resize(2);
  pair.radius = {radius, radius};
  pair.position = {Vector3(-radius, 0, 0), Vector3(radius, 0, 0)};
  pair.velocity = {Vector3(normal, across, 0), Vector3(-normal, -across, 0)};
  const double time_step = pi / EqualSpheres{}.frequency / 4000;
  engine.load(pair, {material, time_step, 0.0});
  Impact result;
  double before = 0.0;
  for (int step = 1; step < 8000 && result.time == 0.0; ++step) {
    engine.run(1);
    result.after = engine.save();
    const double overlap = 2.0 * radius - (result.after.position[0] - result.after.position[1]).norm();
    result.largest_overlap = std::max(result.largest_overlap, overlap);
    if (step > 1 && overlap < 0.0) result.time = (step - 1 + before / (before - overlap)) * time_step;
    before = overlap;
  }
  engine.run(10);  // nothing acts after parting
  result.after = engine.save();
  return result;
}

/// The engines in double that this build has, by turns.
template <typename Check>
void on_each_engine(Check&& check) {
  for (const std::string& name : engine_names_of_build()) {
    if (name != "native" && name != "liggghts") continue;
    SCOPED_TRACE(name);
    check(*make_engine(name, testing::TempDir() + "linear_law.log", 0, all_ranks()));
  }
}

TEST(LinearLaw, AnImpactLastsHalfAPeriodAndReturnsTheFractionEAtAnySpeed) {
  const EqualSpheres pair;
  on_each_engine([&](Engine& engine) {
    for (const double restitution : {1.0, 0.8, 0.3})
      for (const double speed : {1e-3, 0.5}) {
        const Impact impact = collide(engine, linear(restitution, 0.5), speed, 0.0);
        const double log_e = std::log(restitution), share = log_e * log_e / (log_e * log_e + pi * pi);
        // The dashpot at the half step makes the scheme first order: some 1/4000.
        EXPECT_NEAR(impact.time * pair.frequency * std::sqrt(1.0 - share) / pi, 1.0, 1e-3);
        EXPECT_NEAR(-impact.after.velocity[0].x() / speed, restitution, 1e-3);
        if (restitution == 1.0) {
          // Second order, 1/4000 squared; the corner of the force at first touch leaves less than 1e-6.
          EXPECT_NEAR(impact.largest_overlap * pair.frequency / (2.0 * speed), 1.0, 1e-6);
        }
      }
  });
}

TEST(LinearLaw, AnObliqueImpactThatSlidesThroughoutTakesMuTimesTheNormalImpulse) {
  const double friction = 0.1, normal = 0.01, across = 0.01;  // the surface keeps 3/10 of its velocity
  on_each_engine([&](Engine& engine) {
    const Assembly after = collide(engine, linear(1.0, friction), normal, across).after;
    // Impulse of a grain over its mass: 2 v_n along n, so mu 2 v_n across; the spin follows with 5/(2 R). The normal
    // turns by some 2e-4 during the impact, which is 2e-3 of mu.
    EXPECT_NEAR((across - after.velocity[0].y()) / (2.0 * friction * normal), 1.0, 3e-3);
    EXPECT_NEAR(std::abs(after.spin[0].z()) * radius / (5.0 * friction * normal), 1.0, 1e-3);
  });
}

TEST(LinearLaw, AnObliqueImpactThatSticksIsAnOscillationOfTheSurface) {
  const double normal = 0.05, across = 1e-4;
  on_each_engine([&](Engine& engine) {
    const Assembly after = collide(engine, linear(1.0, 1e3), normal, across).after;
    // k_t = k_n, and the surface of equal spheres has 2/7 of the mass m*: after half a period of the normal motion its
    // velocity is cos(pi sqrt(7/2)) of the first. 2/7 of the change is translation.
    const double returned = std::cos(pi * std::sqrt(3.5));
    EXPECT_NEAR(after.velocity[0].y() / across, 1.0 - 2.0 / 7.0 * (1.0 - returned), 2e-3);
    EXPECT_NEAR(std::abs(after.spin[0].z()) * radius / across, 5.0 / 7.0 * (1.0 - returned), 5e-3);
  });
}

TEST(LinearLaw, IsAsStiffAsHertzAtTheCharacteristicVelocity) {
  Material material = linear(1.0, 0.5);
  material.characteristic_velocity = 0.2;
  const PairConstants pair = pair_constants(material, 2e-3, 3e-3);
  const double stiffness = contact_stiffness(material, pair, 1e-6).normal;
  // Overlap of an impact at v: sqrt(m*/k) v for a linear spring, (15 m* v^2 / (16 sqrt(R*) Y*))^(2/5) for Hertz.
  const double hertz = std::pow(
      15.0 * pair.effective_mass * 0.04 / (16.0 * std::sqrt(pair.effective_radius) * pair.effective_modulus), 0.4);
  EXPECT_NEAR(std::sqrt(pair.effective_mass / stiffness) * 0.2 / hertz, 1.0, 1e-12);
  EXPECT_EQ(contact_stiffness(material, pair, 1e-5).normal, stiffness);
}

TEST(LinearLaw, ReadsItsParameterAndHertzDoesNot) {
  EXPECT_NE(text_of_fields(linear(1.0, 0.5)).find("characteristic_velocity = 1\n"), std::string::npos);
  EXPECT_EQ(text_of_fields(Material{}).find("characteristic_velocity"), std::string::npos);
  Material material = linear(1.0, 0.5);
  material.characteristic_velocity = 0.0;
  EXPECT_THROW(validate_fields(material), std::invalid_argument);
}

}  // namespace
}  // namespace flowslide
