// SPDX-License-Identifier: GPL-2.0-or-later
#include "dem/native/boundaries.hpp"

#include <gtest/gtest.h>

#include "grains/contact_forces.hpp"
#include "grains/pair_constants.hpp"
#include "pair_search.hpp"

namespace flowslide::native {
namespace {

constexpr double step = 1e-5;

EngineSettings settings(double drag = 0.0) { return {Material{}, step, drag}; }

TEST(Boundaries, MoveGivesTheLayersTheirVelocities) {
  Assembly cloud = clustered_cloud(1, cube(0.04, false), {.grains = 3});
  cloud.role = {Role::bottom_layer, Role::mobile, Role::top_layer};
  auto bodies = bodies_of(cloud);
  for (Body& body : bodies) Vector3::Map(body.spin) = Vector3(1, 2, 3);
  Boundaries boundaries(cloud.cell, settings());
  const BoundaryMotion motion{{0.1, 0.2, 0.3}, {0.4, 0.5, -0.6}, 0.0, 0.0};
  boundaries.move(motion, bodies, cloud.role);
  EXPECT_EQ(Vector3::Map(bodies[0].velocity), motion.bottom_velocity);
  EXPECT_EQ(Vector3::Map(bodies[1].velocity), cloud.velocity[1]);
  EXPECT_EQ(Vector3::Map(bodies[2].velocity), motion.top_velocity);
  EXPECT_EQ(Vector3::Map(bodies[0].spin), Vector3(0, 0, 0));
  EXPECT_EQ(Vector3::Map(bodies[1].spin), Vector3(1, 2, 3));
  EXPECT_EQ(Vector3::Map(bodies[2].spin), Vector3(0, 0, 0));
}

TEST(Boundaries, AdvanceMovesPlanesAndCarriesGrainsAlongPeriodicAxesOnly) {
  Cell cell;
  cell.lower = {0.01, -0.02, 0.0};
  cell.upper = {0.05, 0.02, 0.03};
  cell.periodic = {true, false, false};
  Assembly cloud = clustered_cloud(2, cell, {.grains = 20});
  auto bodies = bodies_of(cloud);
  Boundaries boundaries(cell, settings());
  boundaries.move({{0, 0, 0.1}, {0, 0, -0.2}, 2.0, -3.0}, bodies, cloud.role);
  boundaries.advance(bodies, cloud.size());
  const double rounding = 1e-17;  // m, of coordinates below 0.1 m
  EXPECT_NEAR(boundaries.cell().lengths().x(), 0.04 * (1 - 2.0 * step), rounding);
  EXPECT_NEAR(boundaries.cell().lengths().y(), 0.04 * (1 + 3.0 * step), rounding);
  EXPECT_NEAR(boundaries.cell().lower.x() + boundaries.cell().upper.x(), 0.06, rounding);
  EXPECT_NEAR(boundaries.cell().lower.z(), 0.1 * step, rounding);
  EXPECT_NEAR(boundaries.cell().upper.z(), 0.03 - 0.2 * step, rounding);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    EXPECT_NEAR(bodies[i].position[0], 0.03 + (1 - 2.0 * step) * (cloud.position[i].x() - 0.03), rounding);
    EXPECT_EQ(bodies[i].position[1], cloud.position[i].y());
    EXPECT_EQ(bodies[i].position[2], cloud.position[i].z());
    EXPECT_EQ(Vector3::Map(bodies[i].velocity), cloud.velocity[i]);
  }
}

TEST(Boundaries, PlanesPushAsTheLawOfPlanesSays) {
  Assembly cloud = clustered_cloud(3, cube(0.03, false), {.grains = 12});
  Dice dice(3);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const int axis = static_cast<int>(i % 3);
    const double inside = 0.015 - cloud.radius[i] * dice.between(0.98, 0.999);
    cloud.position[i] = Vector3::Zero();
    cloud.position[i][axis] = i % 2 == 0 ? inside : -inside;
    if (i == 11) cloud.role[i] = Role::top_layer;  // carried by its layer: no plane acts on it
  }
  auto bodies = bodies_of(cloud);
  for (std::size_t i = 0; i < cloud.size(); ++i) bodies[i].mass = sphere_mass(cloud.radius[i], Material{});
  Boundaries boundaries(cloud.cell, settings());
  boundaries.move({{0.3, 0.2, 0.1}, {0.3, 0.2, -0.2}, 2.0, -3.0}, bodies, cloud.role);
  std::vector<Load> loads(bodies.size(), Load{});
  boundaries.push(bodies, cloud.role, loads);
  PlaneVelocities planes;
  planes.lower = {0.5 * 2.0 * 0.03, -0.5 * 3.0 * 0.03, 0.1};
  planes.upper = {-0.5 * 2.0 * 0.03, 0.5 * 3.0 * 0.03, -0.2};
  std::vector<Vector3> expected(cloud.size(), Vector3::Zero());
  Vector3 upper = Vector3::Zero();
  const ContactForces forces = evaluate_contact_forces(cloud, Material{}, 0.0, planes);
  EXPECT_EQ(forces.plane_contacts.size(), 11u);
  for (const PlaneContact& contact : forces.plane_contacts) {
    expected[contact.grain] += contact.force_on_grain;
    if (contact.upper) upper += contact.force_on_grain;
  }
  // Overlaps of 3e-5 m are differences of coordinates of 1e-2 m: 1e-18 / 3e-6 of rounding.
  for (std::size_t i = 0; i < cloud.size(); ++i)
    EXPECT_LT((Vector3::Map(loads[i].force) - expected[i]).norm(), 1e-11 * expected[i].norm() + 1e-300);
  EXPECT_LT((boundaries.upper_plane() - upper).norm(), 1e-11 * upper.norm());
  EXPECT_GT(upper.norm(), 0.0);
}

TEST(Boundaries, DragActsOnMobileGrainsAndItsMomentsAreKept) {
  Assembly cloud = clustered_cloud(4, cube(0.1, true), {.grains = 20});
  cloud.role[0] = Role::bottom_layer;
  const auto bodies = bodies_of(cloud);
  std::vector<Load> loads(bodies.size(), Load{});
  Boundaries boundaries(cloud.cell, settings(0.5));
  boundaries.push(bodies, cloud.role, loads);
  Vector3 height = Vector3::Zero(), moment = Vector3::Zero();
  EXPECT_EQ(Vector3::Map(loads[0].force), Vector3(0, 0, 0));
  for (std::size_t i = 1; i < cloud.size(); ++i) {
    const Vector3 force = -0.5 * cloud.velocity[i], position = cloud.position[i] - cloud.cell.lower;
    EXPECT_EQ(Vector3::Map(loads[i].force), force);
    height += position.z() * force;
    moment += position.cwiseProduct(force);
  }
  EXPECT_LT((boundaries.drag_height_times_force() - height).norm(), 1e-15);  // rounding of sums of 1e-2 N m
  EXPECT_LT((boundaries.drag_moment() - moment).norm(), 1e-15);
  boundaries.set(settings());
  boundaries.push(bodies, cloud.role, loads);
  EXPECT_EQ(boundaries.drag_moment().norm(), 0.0);
}

TEST(Boundaries, MeanFlowIsLinearAndBoundsWhatNeighboursDoInIt) {
  Assembly cloud = clustered_cloud(5, cube(0.04, false), {.grains = 2});
  auto bodies = bodies_of(cloud);
  Boundaries boundaries(cloud.cell, settings());
  const Vector3 bottom(0.1, 0.0, 0.02), top(0.9, 0.3, -0.03);
  boundaries.move({bottom, top, 2.0, -3.0}, bodies, cloud.role);
  const MeanFlow flow = boundaries.mean_flow();
  const auto at = [&](double z) {
    return Vector3(Vector3::Map(flow.base) + Vector3::Map(flow.slope) * (z - flow.origin));
  };
  EXPECT_LT((at(-0.02) - bottom).norm(), 1e-15);
  EXPECT_LT((at(0.02) - top).norm(), 1e-15);
  EXPECT_LT((at(0.0) - 0.5 * (top + bottom)).norm(), 1e-15);
  EXPECT_EQ(flow.base[3], 0.0);
  EXPECT_EQ(flow.slope[3], 0.0);
  const double reach = 6e-3;
  EXPECT_GE(boundaries.mean_flow_speed(reach), (at(reach) - at(0.0)).norm() + 3.0 * reach);
}

}  // namespace
}  // namespace flowslide::native
