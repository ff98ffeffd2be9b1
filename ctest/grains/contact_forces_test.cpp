// SPDX-License-Identifier: GPL-2.0-or-later
#include "grains/contact_forces.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <map>
#include <random>
#include <utility>

#include "grains/contact_search.hpp"
#include "random_assembly.hpp"
#include "section_stress.hpp"

namespace flowslide {
namespace {

using testing::random_cloud;

/// Two grains of R = 3 and 2.5 mm that touch through the periodic boundary x, overlap 1e-5 m, in a cell of 20 mm.
Assembly pair_across_the_boundary() {
  Assembly pair;
  pair.resize(2);
  pair.cell.upper = Vector3(0.02, 0.02, 0.02);
  pair.cell.periodic = {true, true, true};
  pair.radius = {3e-3, 2.5e-3};
  pair.position[0] = Vector3(0.001, 0.01, 0.01);
  pair.position[1] = Vector3(0.02 - 0.00449, 0.01, 0.01);
  return pair;
}

TEST(EvaluateContactForces, GeometryOfAPairAcrossAPeriodicBoundary) {
  const ContactForces forces = evaluate_contact_forces(pair_across_the_boundary(), Material{}, 5e-7);
  ASSERT_EQ(forces.contacts.size(), 1u);
  EXPECT_TRUE(forces.plane_contacts.empty());
  const Contact& contact = forces.contacts[0];
  EXPECT_EQ(contact.first, 0u);
  EXPECT_EQ(contact.second, 1u);
  // Rounding of positions of 20 mm.
  EXPECT_NEAR(contact.overlap, 1e-5, 1e-16);
  EXPECT_LE((contact.branch - Vector3(5.49e-3, 0, 0)).norm(), 1e-16);
  EXPECT_LE((contact.point_from_first - Vector3(-2.995e-3, 0, 0)).norm(), 1e-16);
  EXPECT_LE((contact.point_from_second - Vector3(2.495e-3, 0, 0)).norm(), 1e-16);
  EXPECT_GT(contact.force.on_first.x(), 0.0);
}

TEST(EvaluateContactForces, DashpotsSeeTheHalfStepOfMobileGrains) {
  const Material material;
  const double time_step = 1e-6;
  Assembly pair = pair_across_the_boundary();
  const ContactForces at_rest = evaluate_contact_forces(pair, material, time_step);
  // Velocities that the half step brings back to zero: v = dt/2 f/m, w = dt/2 T/I_s.
  for (int i = 0; i < 2; ++i) {
    pair.force[i] = Vector3(3.0, -2.0, 1.0) * (1 + i);
    pair.torque[i] = Vector3(1e-3, 2e-3, -3e-3);
    pair.velocity[i] = 0.5 * time_step / sphere_mass(pair.radius[i], material) * pair.force[i];
    pair.spin[i] = 0.5 * time_step / sphere_inertia(pair.radius[i], material) * pair.torque[i];
  }
  const Vector3 still = at_rest.contacts[0].force.on_first;
  const auto force = [&] { return evaluate_contact_forces(pair, material, time_step).contacts[0].force.on_first; };
  EXPECT_LE((force() - still).norm(), 1e-12 * still.norm());
  EXPECT_GT((evaluate_contact_forces(pair, material, 0.0).contacts[0].force.on_first - still).norm(),
            1e-3 * still.norm());
  pair.role[0] = Role::top_layer;  // a glued grain keeps its velocity
  EXPECT_GT((force() - still).norm(), 1e-3 * still.norm());
  pair.velocity[0] = pair.spin[0] = Vector3::Zero();
  EXPECT_LE((force() - still).norm(), 1e-12 * still.norm());
}

TEST(EvaluateContactForces, FindsTheHistoryOfEachPair) {
  Assembly cloud = random_cloud(5, 60, Vector3(0.03, 0.03, 0.03), {true, true, true});
  std::mt19937_64 generator(6);
  std::map<std::pair<std::uint32_t, std::uint32_t>, Vector3> springs;
  for (const TouchingPair& pair : touching_pairs(cloud)) {
    if (generator() % 2 == 0) continue;  // every other pair is new
    const Vector3 spring = testing::uniform_vector(generator, 1e-7);
    springs[{pair.first, pair.second}] = spring;
    cloud.contacts.push_back({pair.first, pair.second, spring, Vector3::Zero()});
  }
  ASSERT_GT(springs.size(), 10u);
  const ContactForces forces = evaluate_contact_forces(cloud, Material{}, 5e-7);
  ASSERT_GT(forces.contacts.size(), springs.size());
  for (const Contact& contact : forces.contacts) {
    const auto found = springs.find({contact.first, contact.second});
    EXPECT_EQ(contact.force.tangential_spring, found == springs.end() ? Vector3(Vector3::Zero()) : found->second);
  }
}

TEST(EvaluateContactForces, PlanesPushMobileGrainsInwards) {
  const Material material;
  Assembly grain;
  grain.resize(1);
  grain.cell.upper = Vector3(0.02, 0.02, 0.005999);  // overlaps of 0.5 um at both z planes
  grain.radius = {3e-3};
  grain.position[0] = Vector3(0.01, 0.0025, 0.0029995);  // and of 0.5 mm at y = 0
  const auto contacts = evaluate_contact_forces(grain, material, 0.0).plane_contacts;
  ASSERT_EQ(contacts.size(), 3u);
  const double mass = sphere_mass(3e-3, material);
  const double force_y = plane_normal_force(material, 3e-3, mass, 5e-4, 0.0);
  const double force_z = plane_normal_force(material, 3e-3, mass, 5e-7, 0.0);
  EXPECT_EQ(contacts[0].axis, 1);
  EXPECT_FALSE(contacts[0].upper);
  EXPECT_LE((contacts[0].force_on_grain - Vector3(0, force_y, 0)).norm(), 1e-12 * force_y);
  EXPECT_LE((contacts[0].point_from_grain - Vector3(0, -0.0025, 0)).norm(), 1e-17);
  EXPECT_EQ(contacts[1].axis, 2);
  EXPECT_FALSE(contacts[1].upper);
  EXPECT_TRUE(contacts[2].upper);
  // The overlap of 0.5 um is known to the rounding of 6 mm: 1e-18 / 5e-7.
  EXPECT_LE((contacts[1].force_on_grain - Vector3(0, 0, force_z)).norm(), 1e-11 * force_z);
  EXPECT_LE((contacts[2].force_on_grain + Vector3(0, 0, force_z)).norm(), 1e-11 * force_z);
  EXPECT_LE((contacts[2].point_from_grain - Vector3(0, 0, 0.0029995)).norm(), 1e-17);
}

TEST(EvaluateContactForces, PlanesCarryAVelocityAndSpareGluedGrainsAndPeriodicAxes) {
  const Material material;
  Assembly grain;
  grain.resize(1);
  grain.cell.upper = Vector3(0.02, 0.02, 0.02);
  grain.radius = {3e-3};
  grain.position[0] = Vector3(0.01, 0.01, 0.0175);
  PlaneVelocities planes;
  planes.upper[2] = -0.1;
  const double mass = sphere_mass(3e-3, material);
  const auto force = [&] { return evaluate_contact_forces(grain, material, 0.0, planes).plane_contacts.at(0); };
  const double approaching = plane_normal_force(material, 3e-3, mass, 5e-4, 0.1);
  EXPECT_NEAR(force().force_on_grain.z(), -approaching, 1e-12 * approaching);
  grain.velocity[0].z() = -0.1;  // flees with the plane
  const double still = plane_normal_force(material, 3e-3, mass, 5e-4, 0.0);
  EXPECT_NEAR(force().force_on_grain.z(), -still, 1e-12 * still);
  grain.role[0] = Role::top_layer;
  EXPECT_TRUE(evaluate_contact_forces(grain, material, 0.0, planes).plane_contacts.empty());
  grain.role[0] = Role::mobile;
  grain.cell.periodic[2] = true;
  EXPECT_TRUE(evaluate_contact_forces(grain, material, 0.0, planes).plane_contacts.empty());
}

TEST(SumOnGrains, ConservesMomentumWithoutPlanes) {
  const Assembly cloud = random_cloud(9, 80, Vector3(0.03, 0.03, 0.03), {true, true, true});
  const ContactForces forces = evaluate_contact_forces(cloud, Material{}, 5e-7);
  const GrainForces sums = sum_on_grains(forces, cloud.size());
  Vector3 total = Vector3::Zero();
  double size = 0.0;
  for (const Vector3& force : sums.force) {
    total += force;
    size += force.norm();
  }
  EXPECT_GT(size, 0.0);
  EXPECT_LE(total.norm(), 1e-14 * size);
}

TEST(ForcesOfTheBoundaries, BalanceTheMobileGrains) {
  Assembly cloud = random_cloud(10, 150, Vector3(0.03, 0.03, 0.03), {true, true, false});
  testing::glue_layers(cloud, 0.006);
  const ContactForces forces = evaluate_contact_forces(cloud, Material{}, 5e-7);
  const GrainForces sums = sum_on_grains(forces, cloud.size());
  Vector3 on_mobile = Vector3::Zero();
  double size = 0.0;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (cloud.role[i] == Role::mobile) {
      on_mobile += sums.force[i];
      size += sums.force[i].norm();
    }
  const Vector3 bottom = testing::force_on_mobile(cloud, forces, Role::bottom_layer);
  const Vector3 top = testing::force_on_mobile(cloud, forces, Role::top_layer);
  EXPECT_GT(bottom.z(), 0.0);
  EXPECT_LT(top.z(), 0.0);
  // Forces among mobile grains cancel, what remains comes from the two boundaries; rounding of the sum.
  EXPECT_LE((on_mobile - bottom - top).norm(), 1e-13 * size);
}

/// Velocity Verlet with the contact law in the order of the engines: enough to make states with true histories.
class SmallEngine {
 public:
  SmallEngine(Assembly assembly, double time_step) : a(std::move(assembly)), dt(time_step) {}

  void step() {
    for (std::size_t i = 0; i < a.size(); ++i) {
      if (a.role[i] == Role::mobile) kick(i);
      a.position[i] += dt * a.velocity[i];
    }
    evaluate();
    for (std::size_t i = 0; i < a.size(); ++i)
      if (a.role[i] == Role::mobile) kick(i);
  }

  Assembly a;

 private:
  void kick(std::size_t i) {
    a.velocity[i] += 0.5 * dt / sphere_mass(a.radius[i], material) * a.force[i];
    a.spin[i] += 0.5 * dt / sphere_inertia(a.radius[i], material) * a.torque[i];
  }

  void evaluate() {
    for (auto* array : {&a.force, &a.torque})
      for (Vector3& value : *array) value.setZero();
    std::vector<ContactHistory> histories;
    for (const auto& [i, j] : touching_pairs(a)) {
      ContactHistory history{i, j, Vector3::Zero(), Vector3::Zero()};
      for (const ContactHistory& old : a.contacts)
        if (old.first == i && old.second == j) history = old;
      const Vector3 branch = a.cell.nearest_image(a.position[i] - a.position[j]);
      const ContactKinematics motion{branch.normalized(), a.radius[i] + a.radius[j] - branch.norm(),
                                     a.velocity[i] - a.velocity[j], a.spin[i], a.spin[j]};
      const ContactForce force = step_contact(material, pair_constants(material, a.radius[i], a.radius[j]), motion,
                                              {{history.tangential_spring}, {history.rolling_torque}}, dt);
      histories.push_back({i, j, force.tangential_spring, force.rolling_torque});
      a.force[i] += force.on_first;
      a.force[j] -= force.on_first;
      a.torque[i] += force.torque_on_first;
      a.torque[j] += force.torque_on_second;
    }
    a.contacts = histories;
  }

  Material material;
  double dt;
};

TEST(EvaluateContactForces, ReproducesTheForcesOfTheStepThatMadeTheState) {
  Assembly start = random_cloud(11, 40, Vector3(0.022, 0.022, 0.022), {true, true, true});
  for (std::size_t i = 0; i < start.size(); ++i) {
    start.radius[i] *= 0.6;  // fewer and milder overlaps
    start.force[i] = start.torque[i] = Vector3::Zero();
  }
  start.role[3] = Role::bottom_layer;
  SmallEngine engine(start, 2e-7);
  double size = 0.0, error = 0.0;
  for (int step = 0; step < 300; ++step) {
    engine.step();
    const GrainForces sums = sum_on_grains(evaluate_contact_forces(engine.a, Material{}, 2e-7), engine.a.size());
    for (std::size_t i = 0; i < engine.a.size(); ++i) {
      size = std::max(size, engine.a.force[i].norm());
      error = std::max(error, (sums.force[i] - engine.a.force[i]).norm());
      error = std::max(error, (sums.torque[i] - engine.a.torque[i]).norm() / start.radius[i]);
    }
  }
  EXPECT_GT(engine.a.contacts.size(), 5u);
  // The half-step velocity is reconstructed to rounding, and no contact changes its branch.
  EXPECT_LE(error, 1e-12 * size);
}

}  // namespace
}  // namespace flowslide
