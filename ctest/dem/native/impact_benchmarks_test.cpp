// SPDX-License-Identifier: GPL-2.0-or-later
// The benchmarks of Chung, Y.C., Ooi, J.Y.: Benchmark tests for verifying discrete element modelling codes at particle
// impact level, Granular Matter 13 (2011) 643-656, doi:10.1007/s10035-011-0277-0, where this law applies. Materials and
// speeds are theirs. Planes are frictionless here, so that oblique impacts are those of two spheres.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "dem/native/native_engine.hpp"
#include "grains/contact_law.hpp"
#include "support/clustered_cloud.hpp"

namespace flowslide {
namespace {

struct Solid {
  const char* name;
  double modulus, poisson, density, friction, restitution, radius;
};

Material material_of(const Solid& solid, double friction, double restitution) {
  Material m;
  m.youngs_modulus = solid.modulus;
  m.poisson_ratio = solid.poisson;
  m.density = solid.density;
  m.sliding_friction = friction;
  m.rolling_friction = 0.0;
  m.restitution = restitution;
  return m;
}

constexpr Solid glass{"glass", 4.8e10, 0.20, 2800.0, 0.35, 1.0, 0.010};
constexpr Solid limestone{"limestone", 2.0e10, 0.25, 2500.0, 0.35, 1.0, 0.025};
constexpr Solid aluminium_alloy{"aluminium alloy", 7.0e10, 0.33, 2699.0, 0.092, 0.98, 0.0025};
constexpr Solid magnesium_alloy{"magnesium alloy", 4.0e10, 0.35, 1800.0, 0.10, 1.0, 0.10};

/// What an elastic impact of Hertz does: largest overlap (m), force (N), and time (s).
struct Hertz {
  Hertz(const PairConstants& pair, double speed) {
    overlap = std::pow(
        15.0 * pair.effective_mass * speed * speed / (16.0 * std::sqrt(pair.effective_radius) * pair.effective_modulus),
        0.4);
    force = 4.0 / 3.0 * pair.effective_modulus * std::sqrt(pair.effective_radius * overlap) * overlap;
    time = 0.8 * std::sqrt(std::numbers::pi) * std::tgamma(0.4) / std::tgamma(0.9) * overlap / speed;
  }
  double overlap, force, time;
};

/// What an engine has seen of an impact of grain 0.
struct Impact {
  Assembly after;
  double largest_force = 0.0, largest_overlap = 0.0, time = 0.0;
};

/// Runs an impact that Hertz expects to last `hertz.time`, 2000 steps, until it must be over.
template <typename Real, typename Overlap>
Impact impact(const Assembly& start, const Material& m, const Hertz& hertz, Overlap overlap_of) {
  constexpr int steps = 2000;
  const double time_step = hertz.time / steps;
  NativeEngine<Real> engine;
  engine.load(start, {m, time_step, 0.0});
  Impact result;
  double before = 0.0;
  for (int s = 1; s < 2 * steps && result.time == 0.0; ++s) {
    engine.run(1);
    result.after = engine.save();
    const double overlap = overlap_of(result.after);
    result.largest_overlap = std::max(result.largest_overlap, overlap);
    result.largest_force = std::max(result.largest_force, result.after.force[0].norm());
    if (s > 1 && overlap < 0.0) result.time = (s - 1 + before / (before - overlap)) * time_step;
    before = overlap;
  }
  engine.run(10);  // no force acts after separation
  result.after = engine.save();
  return result;
}

/// Two grains on the x axis that just touch in a large box.
Assembly touching_pair(double first, double second) {
  Assembly pair;
  pair.cell = cube(20.0 * std::max(first, second), false);
  pair.resize(2);
  pair.radius = {first, second};
  pair.position = {Vector3(-first, 0, 0), Vector3(second, 0, 0)};
  return pair;
}

template <typename Real>
Impact collide(const Assembly& pair, const Material& m) {
  const Hertz hertz(pair_constants(m, pair.radius[0], pair.radius[1]), (pair.velocity[0] - pair.velocity[1]).norm());
  return impact<Real>(pair, m, hertz, [](const Assembly& a) {
    return a.radius[0] + a.radius[1] - (a.position[0] - a.position[1]).norm();
  });
}

template <typename Real>
class ImpactBenchmarksOf : public testing::Test {};
using Precisions = testing::Types<double, float>;
TYPED_TEST_SUITE(ImpactBenchmarksOf, Precisions);

/// Second order in dt, 1/2000 of the impact; in float, rounding of some 1000 steps, adding up at random.
template <typename Real>
constexpr double elastic_tolerance = std::is_same_v<Real, double> ? 2e-6 : 2e-5;

TYPED_TEST(ImpactBenchmarksOf, Test1ElasticNormalImpactOfTwoIdenticalSpheres) {
  for (const Solid& solid : {glass, limestone}) {
    const Material m = material_of(solid, solid.friction, 1.0);
    Assembly pair = touching_pair(solid.radius, solid.radius);
    pair.velocity = {Vector3(10.0, 0, 0), Vector3(-10.0, 0, 0)};
    const Hertz hertz(pair_constants(m, solid.radius, solid.radius), 20.0);
    const Impact seen = collide<TypeParam>(pair, m);
    std::printf("%-15s force %.6g N (%.1e off), time %.6g us (%.1e off)\n", solid.name, seen.largest_force,
                seen.largest_force / hertz.force - 1.0, 1e6 * seen.time, seen.time / hertz.time - 1.0);
    EXPECT_NEAR(seen.largest_force / hertz.force, 1.0, elastic_tolerance<TypeParam>);
    EXPECT_NEAR(seen.largest_overlap / hertz.overlap, 1.0, elastic_tolerance<TypeParam>);
    EXPECT_NEAR(seen.time / hertz.time, 1.0, elastic_tolerance<TypeParam>);
    EXPECT_NEAR(seen.after.velocity[0].x(), -10.0, 10.0 * elastic_tolerance<TypeParam>);
    EXPECT_EQ(seen.after.velocity[0].y(), 0.0);
    EXPECT_EQ(seen.after.spin[0].norm(), 0.0);
  }
}

/// A sphere that just touches the lower plane along x, and hits it with `speed`.
template <typename Real>
Impact hit_plane(const Solid& solid, double speed, double restitution) {
  const Material m = material_of(solid, solid.friction, restitution);
  Assembly one;
  one.cell = cube(20.0 * solid.radius, false);
  one.resize(1);
  one.radius = {solid.radius};
  one.position = {Vector3(one.cell.lower.x() + solid.radius, 0, 0)};
  one.velocity = {Vector3(-speed, 0, 0)};
  return impact<Real>(one, m, Hertz(plane_constants(m, solid.radius), speed), [](const Assembly& a) {
    return a.radius[0] - (a.position[0].x() - a.cell.lower.x());
  });
}

TYPED_TEST(ImpactBenchmarksOf, Test2ElasticNormalImpactOfASphereWithAPlane) {
  // As here, the plane is of the sphere's material.
  for (const Solid& solid : {aluminium_alloy, magnesium_alloy}) {
    const Hertz hertz(plane_constants(material_of(solid, 0.0, 1.0), solid.radius), 0.2);
    const Impact seen = hit_plane<TypeParam>(solid, 0.2, 1.0);
    std::printf("%-15s force %.6g N (%.1e off), time %.6g us (%.1e off)\n", solid.name, seen.largest_force,
                seen.largest_force / hertz.force - 1.0, 1e6 * seen.time, seen.time / hertz.time - 1.0);
    EXPECT_NEAR(seen.largest_force / hertz.force, 1.0, elastic_tolerance<TypeParam>);
    EXPECT_NEAR(seen.largest_overlap / hertz.overlap, 1.0, elastic_tolerance<TypeParam>);
    EXPECT_NEAR(seen.time / hertz.time, 1.0, elastic_tolerance<TypeParam>);
    EXPECT_NEAR(seen.after.velocity[0].x() / 0.2, 1.0, elastic_tolerance<TypeParam>);
  }
}

TYPED_TEST(ImpactBenchmarksOf, Test3NormalImpactReturnsEachCoefficientOfRestitution) {
  for (const double restitution : {0.2, 0.4, 0.6, 0.8, 1.0}) {
    const double plane = hit_plane<TypeParam>(aluminium_alloy, 0.2, restitution).after.velocity[0].x() / 0.2;
    Assembly pair = touching_pair(limestone.radius, 0.5 * limestone.radius);
    pair.velocity[0].x() = 3.9;
    const Assembly after = collide<TypeParam>(pair, material_of(limestone, 0.0, restitution)).after;
    const double spheres = (after.velocity[1].x() - after.velocity[0].x()) / 3.9;
    std::printf("restitution %.1f: %.5f of a plane, %.5f of two spheres\n", restitution, plane, spheres);
    // First order in dt with dashpots: 1/2000 of the impact, times 1/e where little is left.
    EXPECT_NEAR(plane, restitution, 1e-3);
    EXPECT_NEAR(spheres, restitution, 1e-3);
  }
}

/// Sphere 0 hits another of 1000 times its radius at an angle to the normal (x), without spin, or with a spin about z
/// and no tangential speed.
struct Oblique {
  double normal, tangential, spin;              ///< speeds before, m/s, rad/s
  Vector3 velocity, spin_after;                 ///< of sphere 0 after
};

template <typename Real>
Oblique oblique(const Solid& solid, const Material& m, double speed, double degrees, double spin) {
  const double angle = degrees * std::numbers::pi / 180.0;
  Oblique result{speed * std::cos(angle), speed * std::sin(angle), spin, {}, {}};
  Assembly pair = touching_pair(solid.radius, 1000.0 * solid.radius);
  pair.velocity[0] = {result.normal, result.tangential, 0.0};
  pair.spin[0].z() = spin;
  const Assembly after = collide<Real>(pair, m).after;
  result.velocity = after.velocity[0];
  result.spin_after = after.spin[0];
  return result;
}

TYPED_TEST(ImpactBenchmarksOf, Test4ObliqueImpactSlidesThroughoutAtLargeAngles) {
  // A glued sphere of 1000 times the radius is the nearest to their plane: with v_n the impulse is m (1 + e) v_n, all
  // of which slides if tan(angle) > 7/2 mu (1 + e): then the tangential speed loses mu (1 + e) v_n and the spin is
  // 5/2 of that over R. Their speed is 3.9 m/s, their spheres are of aluminium oxide.
  constexpr Solid oxide{"aluminium oxide", 3.8e11, 0.23, 4000.0, 0.092, 0.98, 0.0025};
  const Material m = material_of(oxide, oxide.friction, oxide.restitution);
  for (const double degrees : {50.0, 60.0, 70.0, 80.0}) {
    ASSERT_GT(std::tan(degrees * std::numbers::pi / 180.0), 3.5 * oxide.friction * (1.0 + oxide.restitution));
    const Oblique hit = oblique<TypeParam>(oxide, m, 3.9, degrees, 0.0);
    const double e = -hit.velocity.x() / hit.normal;
    const double lost = oxide.friction * (1.0 + e) * hit.normal;
    const double restitution = hit.velocity.y() / hit.tangential, expected = 1.0 - lost / hit.tangential;
    std::printf("%g degrees: tangential restitution %.6f (%.1e off), spin %.2f rad/s (%.1e off)\n", degrees,
                restitution, restitution - expected, hit.spin_after.z(),
                hit.spin_after.z() / (-2.5 * lost / oxide.radius) - 1.0);
    // The dashpot keeps all of the impulse under the cap while it pushes; at the end it pulls with less than 1e-3 of
    // the largest force. The large sphere takes 1e-9 of the impulse, the normal turns by 1e-6.
    EXPECT_NEAR(e, oxide.restitution, 1e-4);
    EXPECT_NEAR(restitution, expected, 1e-4);
    EXPECT_NEAR(hit.spin_after.z() * oxide.radius / (-2.5 * lost), 1.0, 2e-3);
    EXPECT_NEAR(hit.velocity.z(), 0.0, 1e-12);
  }
}

TYPED_TEST(ImpactBenchmarksOf, Test6ASpinningSphereIsPushedAsideByFriction) {
  // Normal impact with a spin: gross sliding while the surface is faster than the impulse of friction can stop.
  for (const Solid& solid : {aluminium_alloy, glass}) {
    const Material m = material_of(solid, solid.friction, 1.0);
    const double normal = 0.2, lost = solid.friction * 2.0 * normal;
    const double spin = -1.5 * 3.5 * lost / solid.radius;
    const Oblique hit = oblique<TypeParam>(solid, m, normal, 0.0, spin);
    std::printf("%s: speed %.6f m/s, expected %.6f\n", solid.name, hit.velocity.y(), lost);
    EXPECT_NEAR(hit.velocity.y() / lost, 1.0, 1e-4);
    // The lever arm is the radius less half an overlap of up to 1e-3 of it.
    EXPECT_NEAR((hit.spin_after.z() - spin) * solid.radius / (2.5 * lost), 1.0, 1e-3);
  }
}

TYPED_TEST(ImpactBenchmarksOf, Test7ObliqueImpactOfTwoIdenticalSpheres) {
  // A sphere at rest is hit: half of the impulse of a fixed plane, m (1 + e) v_n / 2, and the contact slides throughout
  // if tan(angle) > 7/2 mu (1 + e). Both get the same spin, as the point of contact pushes both to the same side.
  const Material m = material_of(aluminium_alloy, 0.092, 1.0);
  constexpr double speed = 2e-3;  // slow, so that the normal hardly turns while they touch: by v_t T / 2R, some 1e-5
  for (const double degrees : {45.0, 60.0, 75.0}) {
    const double angle = degrees * std::numbers::pi / 180.0, normal = speed * std::cos(angle);
    Assembly pair = touching_pair(aluminium_alloy.radius, aluminium_alloy.radius);
    pair.velocity[0] = {normal, speed * std::sin(angle), 0.0};
    const Assembly after = collide<TypeParam>(pair, m).after;
    const double lost = 0.092 * normal, spin = -2.5 * lost / aluminium_alloy.radius;
    std::printf("%g degrees: spin %.5f and %.5f, expected %.5f rad/s\n", degrees, after.spin[0].z(), after.spin[1].z(),
                spin);
    EXPECT_NEAR(after.velocity[1].x() / normal, 1.0, 1e-4);
    EXPECT_NEAR(after.velocity[1].y() / lost, 1.0, 1e-5 / 0.092 + 1e-4);
    EXPECT_NEAR(after.spin[0].z() / spin, 1.0, 1e-3);
    EXPECT_NEAR(after.spin[1].z() / after.spin[0].z(), 1.0, 1e-5);
  }
}

TYPED_TEST(ImpactBenchmarksOf, AtSmallAnglesTheContactSticksAndKeepsItsAngularMomentum) {
  // At small angles the contact sticks and what is left of the tangential speed depends on the stiffnesses, but it
  // is no less than if the surface came back with all of its speed, 3/7, and no more than without friction, 1.
  const Material m = material_of(aluminium_alloy, 0.35, 1.0);
  for (const double degrees : {5.0, 15.0, 30.0}) {
    const Oblique hit = oblique<TypeParam>(aluminium_alloy, m, 0.2, degrees, 0.0);
    const double restitution = hit.velocity.y() / hit.tangential;
    EXPECT_GT(restitution, 3.0 / 7.0);
    EXPECT_LT(restitution, 1.0);
    // Angular momentum about the point of contact is kept: 2/5 m R^2 w + m R v_t.
    const double before = hit.tangential, after = hit.velocity.y() - 0.4 * aluminium_alloy.radius * hit.spin_after.z();
    std::printf("%g degrees: tangential restitution %.4f\n", degrees, restitution);
    EXPECT_NEAR(after / before, 1.0, 1e-3);
  }
}

}  // namespace
}  // namespace flowslide
