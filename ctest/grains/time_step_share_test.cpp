// SPDX-License-Identifier: GPL-2.0-or-later
#include "grains/time_step_share.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "grains/pair_constants.hpp"

namespace flowslide {
namespace {

constexpr double radius = 3e-3, overlap = 1e-5;

/// Two spheres that touch along x, in a cell without planes near them.
Assembly touching_pair() {
  Assembly pair;
  pair.cell.lower.setConstant(-0.1);
  pair.cell.upper.setConstant(0.1);
  pair.resize(2);
  pair.radius = {radius, radius};
  pair.position[1] = Vector3(2.0 * radius - overlap, 0.0, 0.0);
  return pair;
}

Material undamped() {
  Material material;
  material.restitution = 1.0;
  material.sliding_friction = material.rolling_friction = 0.0;
  return material;
}

double normal_stiffness(const Material& material) {  // S_n
  const PairConstants pair = pair_constants(material, radius, radius);
  return 2.0 * pair.effective_modulus * std::sqrt(pair.effective_radius * overlap);
}

TEST(TimeStepShare, IsOneAtTwoOverOmegaOfAnUndampedSpring) {
  const Material material = undamped();
  const double omega = std::sqrt(normal_stiffness(material) / (0.5 * sphere_mass(radius, material)));
  EXPECT_NEAR(time_step_share(touching_pair(), material, 2.0 / omega), 1.0, 1e-9);
  EXPECT_NEAR(time_step_share(touching_pair(), material, 1.0 / omega), 0.25, 1e-9);
}

TEST(TimeStepShare, CountsTheSpinsThatAStickingContactTurns) {
  Material material = undamped();
  material.sliding_friction = 0.5;
  const PairConstants pair = pair_constants(material, radius, radius);
  const double stiffness = 8.0 * pair.effective_shear_modulus * std::sqrt(pair.effective_radius * overlap);
  // 1/m of two spheres, and c^2/I of two arms about their centres
  const double arm = radius - 0.5 * overlap;
  const double inverse_mass = 2.0 / sphere_mass(radius, material) + 2.0 * arm * arm / sphere_inertia(radius, material);
  EXPECT_NEAR(time_step_share(touching_pair(), material, 1e-5), 0.25e-10 * stiffness * inverse_mass, 1e-9);
}

TEST(TimeStepShare, CountsDashpotsWithTheVelocityOfTheHalfStep) {
  Material material = undamped();
  material.restitution = 0.3;
  const double stiffness = normal_stiffness(material), mass = 0.5 * sphere_mass(radius, material);
  const double beta = std::log(0.3) / std::hypot(std::log(0.3), M_PI);
  const double damping = -2.0 * std::sqrt(5.0 / 6.0) * beta * std::sqrt(stiffness * mass);
  const double step = 1e-5;
  EXPECT_NEAR(time_step_share(touching_pair(), material, step),
              0.25 * (step * step * stiffness + 2.0 * step * damping) / mass, 1e-9);
}

/// The pair itself, moved by the scheme with forces linear in the small motion: what the share says must happen.
double swing_after(const Material& material, double step, int steps) {
  const double stiffness = normal_stiffness(material), mass = 0.5 * sphere_mass(radius, material);
  const double beta = material.restitution < 1.0
                          ? std::log(material.restitution) / std::hypot(std::log(material.restitution), M_PI)
                          : 0.0;
  const double damping = -2.0 * std::sqrt(5.0 / 6.0) * beta * std::sqrt(stiffness * mass);
  double x = 1.0, v = 0.0;
  for (int i = 0; i < steps; ++i) {
    v += step * (-stiffness * x - damping * v) / mass;
    x += step * v;
  }
  return std::abs(x);
}

TEST(TimeStepShare, TellsWhetherASwingGrows) {
  Material material = undamped();
  for (const double restitution : {1.0, 0.8, 0.3}) {
    material.restitution = restitution;
    double step = 1e-5;
    for (int i = 0; i < 40; ++i) step /= std::sqrt(time_step_share(touching_pair(), material, step));
    EXPECT_LT(swing_after(material, 0.99 * step, 1000), 10.0) << restitution;
    EXPECT_GT(swing_after(material, 1.01 * step, 1000), 1e6) << restitution;
  }
}

TEST(TimeStepShare, CountsPlanesAndLeavesGluedGrainsOut) {
  const Material material = undamped();
  Assembly pair = touching_pair();
  pair.role[0] = Role::bottom_layer;
  const double omega = std::sqrt(normal_stiffness(material) / sphere_mass(radius, material));
  EXPECT_NEAR(time_step_share(pair, material, 2.0 / omega), 1.0, 1e-9);  // one mass on a fixed spring
  Assembly one;
  one.cell.upper.setConstant(0.1);
  one.resize(1);
  one.radius = {radius};
  one.position[0] = Vector3(0.05, 0.05, radius - 2e-5);
  const PairConstants plane = plane_constants(material, radius);
  const double stiffness = 2.0 * plane.effective_modulus * std::sqrt(radius * 2e-5);
  EXPECT_NEAR(time_step_share(one, material, 1e-5), 0.25e-10 * stiffness / plane.effective_mass, 1e-9);
}

TEST(TimeStepShare, IsZeroWithoutContacts) {
  Assembly pair = touching_pair();
  pair.position[1].x() = 0.05;
  EXPECT_EQ(time_step_share(pair, Material{}, 1e-5), 0.0);
}

TEST(TimeStepShare, TheStepAtTheEdgeLiesBetweenUndampedAndAllDamped) {
  EXPECT_NEAR(time_step_at_edge(1e-5, 1.0), 1e-5, 1e-20);
  EXPECT_LT(time_step_at_edge(1e-5, 2.0), 1e-5 / std::sqrt(2.0));
  EXPECT_GT(time_step_at_edge(1e-5, 2.0), 0.5e-5);
}

}  // namespace
}  // namespace flowslide
