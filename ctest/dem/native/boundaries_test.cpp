// SPDX-License-Identifier: GPL-2.0-or-later
#include "dem/native/boundaries.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "grains/contact_forces.hpp"
#include "grains/pair_constants.hpp"
#include "pair_search.hpp"

namespace flowslide::native::boundaries_test {
namespace {

constexpr double step = 1e-5;

EngineSettings settings(double drag = 0.0) { return {Material{}, step, drag}; }

constexpr double reach_of_lists = 3e-4;  // m

TEST(Boundaries, AdvanceMovesPlanesAndCarriesGrainsAlongPeriodicAxesOnly) {
  Cell cell;
  cell.lower = {0.01, -0.02, 0.0};
  cell.upper = {0.05, 0.02, 0.03};
  cell.periodic = {true, false, false};
  Assembly cloud = clustered_cloud(2, cell, {.grains = 20});
  auto bodies = bodies_of(cloud);
  const GrainRange range{3, 15};
  Boundaries boundaries(cell, settings(), range);
  EXPECT_FALSE(boundaries.compresses());
  boundaries.move({{0, 0, 0.1}, {0, 0, -0.2}, 2.0, -3.0});
  EXPECT_TRUE(boundaries.compresses());
  EXPECT_TRUE(boundaries.carries());
  boundaries.advance();
  boundaries.carry(bodies);
  const double rounding = 1e-17;  // m, of coordinates below 0.1 m
  EXPECT_NEAR(boundaries.cell().lengths().x(), 0.04 * (1 - 2.0 * step), rounding);
  EXPECT_NEAR(boundaries.cell().lengths().y(), 0.04 * (1 + 3.0 * step), rounding);
  EXPECT_NEAR(boundaries.cell().lower.x() + boundaries.cell().upper.x(), 0.06, rounding);
  EXPECT_NEAR(boundaries.cell().lower.z(), 0.1 * step, rounding);
  EXPECT_NEAR(boundaries.cell().upper.z(), 0.03 - 0.2 * step, rounding);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const double carried = 0.03 + (1 - 2.0 * step) * (cloud.position[i].x() - 0.03);
    EXPECT_NEAR(bodies[i].position[0], range.owns(i) ? carried : cloud.position[i].x(), rounding);
    EXPECT_EQ(bodies[i].position[1], cloud.position[i].y());
    EXPECT_EQ(bodies[i].position[2], cloud.position[i].z());
    EXPECT_EQ(Vector3::Map(bodies[i].velocity), cloud.velocity[i]);
  }
  boundaries.move({{0, 0, 0.1}, {0, 0, -0.2}, 0.0, -3.0});  // the sides along y are rigid and carry nobody
  EXPECT_TRUE(boundaries.compresses());
  EXPECT_FALSE(boundaries.carries());
}

/// Grains that touch a plane each, the last of them glued.
Assembly grains_at_planes() {
  Assembly cloud = clustered_cloud(3, cube(0.03, false), {.grains = 12});
  Dice dice(3);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const int axis = static_cast<int>(i % 3);
    const double inside = 0.015 - cloud.radius[i] * dice.between(0.98, 0.999);
    cloud.position[i] = Vector3::Zero();
    cloud.position[i][axis] = i % 2 == 0 ? inside : -inside;
  }
  cloud.role[11] = Role::top_layer;  // carried by its layer: no plane acts on it
  return cloud;
}

template <typename Real>
void expect_law_of_planes(double tolerance) {
  const Assembly cloud = grains_at_planes();
  const auto bodies = bodies_of(cloud);
  std::vector<Load<Real>> loads(bodies.size());
  Vector3 upper = Vector3::Zero(), expected_upper = Vector3::Zero();
  for (const GrainRange range : {GrainRange{0, 5}, GrainRange{5, 12}}) {
    Boundaries boundaries(cloud.cell, settings(), range);
    boundaries.move({{0.3, 0.2, 0.1}, {0.3, 0.2, -0.2}, 2.0, -3.0});
    boundaries.find_near(bodies, cloud.role, reach_of_lists);
    boundaries.push(range, bodies, cloud.role, loads);
    boundaries.add_upper_plane(bodies, upper);
  }
  PlaneVelocities planes;
  planes.lower = {0.5 * 2.0 * 0.03, -0.5 * 3.0 * 0.03, 0.1};
  planes.upper = {-0.5 * 2.0 * 0.03, 0.5 * 3.0 * 0.03, -0.2};
  std::vector<Vector3> expected(cloud.size(), Vector3::Zero());
  const ContactForces forces = evaluate_contact_forces(cloud, Material{}, 0.0, planes);
  EXPECT_EQ(forces.plane_contacts.size(), 11u);
  for (const PlaneContact& contact : forces.plane_contacts) {
    expected[contact.grain] += contact.force_on_grain;
    if (contact.upper) expected_upper += contact.force_on_grain;
  }
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Vector3 force(loads[i].force[0], loads[i].force[1], loads[i].force[2]);
    EXPECT_LT((force - expected[i]).norm(), tolerance * expected[i].norm() + 1e-300);
  }
  EXPECT_LT((upper - expected_upper).norm(), 1e-11 * upper.norm());
  EXPECT_GT(upper.norm(), 0.0);
}

TEST(Boundaries, PlanesPushAsTheLawOfPlanesSays) {
  // Overlaps of 3e-5 m are differences of coordinates of 1e-2 m: 1e-18 / 3e-6 of rounding.
  expect_law_of_planes<double>(1e-11);
  expect_law_of_planes<float>(0x1p-24);  // the sum is rounded once
}

TEST(Boundaries, OnlyGrainsNearAPlaneAreLookedAt) {
  Assembly cloud = grains_at_planes();
  auto bodies = bodies_of(cloud);
  const auto pushed = [&](double away, double skin) {
    bodies[0].position[0] = 0.015 - bodies[0].radius - away;
    Boundaries boundaries(cloud.cell, settings(), {0, 1});
    boundaries.find_near(bodies, cloud.role, skin);
    bodies[0].position[0] = 0.015 - 0.99 * bodies[0].radius;
    std::vector<Load<double>> loads(bodies.size());
    boundaries.push({0, 1}, bodies, cloud.role, loads);
    return loads[0].force[0];
  };
  EXPECT_LT(pushed(0.99 * reach_of_lists, reach_of_lists), 0.0);
  EXPECT_EQ(pushed(1.01 * reach_of_lists, reach_of_lists), 0.0);
}

TEST(Boundaries, DragActsOnMobileGrainsOfTheShare) {
  Assembly cloud = clustered_cloud(4, cube(0.1, true), {.grains = 20});
  cloud.role[0] = Role::bottom_layer;
  const auto bodies = bodies_of(cloud);
  std::vector<Load<double>> loads(bodies.size());
  Boundaries boundaries(cloud.cell, settings(0.5), {0, 10});
  boundaries.find_near(bodies, cloud.role, reach_of_lists);
  boundaries.push({0, 10}, bodies, cloud.role, loads);
  EXPECT_EQ(Vector3::Map(loads[0].force), Vector3(0, 0, 0));
  for (std::size_t i = 1; i < 10; ++i) EXPECT_EQ(Vector3::Map(loads[i].force), -0.5 * cloud.velocity[i]);
  for (std::size_t i = 10; i < 20; ++i) EXPECT_EQ(Vector3::Map(loads[i].force), Vector3(0, 0, 0));
  boundaries.set(settings());
  loads.assign(bodies.size(), {});
  boundaries.push({0, 10}, bodies, cloud.role, loads);
  for (const Load<double>& load : loads) EXPECT_EQ(Vector3::Map(load.force), Vector3(0, 0, 0));
}

TEST(Boundaries, DragRelativeToTheCompressionIsThatOfTheFieldAndLeavesTheSums) {
  Assembly cloud = clustered_cloud(4, cube(0.1, false), {.grains = 20});
  const auto bodies = bodies_of(cloud);
  Boundaries boundaries(cloud.cell, {Material{}, step, 0.5, DragReference::uniform_compression}, {5, 20});
  const BoundaryMotion motion{{0, 0, 0.1}, {0, 0, -0.2}, 2.0, -3.0};
  boundaries.move(motion);
  std::vector<Load<double>> loads(bodies.size());
  boundaries.push({5, 20}, bodies, cloud.role, loads);
  const UniformFlow flow = uniform_flow(cloud.cell, motion);
  StressSums sums;
  boundaries.remove_drag_moments(bodies, cloud.role, sums);
  for (std::size_t i = 5; i < 20; ++i) {
    const Vector3 force = -0.5 * (cloud.velocity[i] - flow.at(cloud.position[i]));
    EXPECT_EQ(Vector3::Map(loads[i].force), force);
    const Vector3 arm = cloud.position[i] - cloud.cell.lower;
    sums.mobile_height_times_force += arm.z() * force;
    sums.mobile_moment += arm.cwiseProduct(force);
  }
  EXPECT_LT(sums.mobile_height_times_force.norm(), 1e-17);  // N m: 15 terms of 1e-2 N m
  EXPECT_LT(sums.mobile_moment.norm(), 1e-17);
}

TEST(Boundaries, FoldsAlongPeriodicAxesAndConfinesAlongRigidOnes) {
  Cell cell = cube(0.04, false);
  cell.periodic[1] = true;
  const Boundaries boundaries(cell, settings(), {0, 0});
  const Box periods = boundaries.periods(), confines = boundaries.confines();
  for (const int axis : {0, 1, 2, 3}) {
    const bool periodic = axis == 1;
    EXPECT_EQ(periods.lower[axis], periodic ? -0.02 : -std::numeric_limits<double>::infinity());
    EXPECT_EQ(periods.upper[axis], periodic ? 0.02 : std::numeric_limits<double>::infinity());
    const bool rigid = axis == 0 || axis == 2;
    // Finite, so that a number that got lost is outside.
    EXPECT_EQ(confines.lower[axis], rigid ? -0.02 : std::numeric_limits<double>::lowest());
    EXPECT_EQ(confines.upper[axis], rigid ? 0.02 : std::numeric_limits<double>::max());
  }
}

TEST(Boundaries, MeanFlowIsLinearAndBoundsWhatNeighboursDoInIt) {
  Cell cell = cube(0.04, true);
  cell.periodic[2] = false;
  Boundaries boundaries(cell, settings(), {0, 0});
  const Vector3 bottom(0.1, 0.0, 0.02), top(0.9, 0.3, -0.03);
  boundaries.move({bottom, top, 2.0, -3.0});
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
  EXPECT_EQ(boundaries.side_speed(), 0.0);
}

TEST(Boundaries, NothingFlowsThroughARigidSideNorAPeriodicTopAlongZ) {
  const BoundaryMotion motion{Vector3::Zero(), Vector3(0.9, 0.3, -0.03), 2.0, -3.0};
  Boundaries rigid(cube(0.04, false), settings(), {0, 0});
  rigid.move(motion);
  EXPECT_EQ(rigid.mean_flow().slope[0], 0.0);
  EXPECT_EQ(rigid.mean_flow().slope[1], 0.0);
  EXPECT_DOUBLE_EQ(rigid.mean_flow().slope[2], -0.03 / 0.04);
  EXPECT_DOUBLE_EQ(rigid.side_speed(), 3.0 * 0.02);
  Boundaries periodic(cube(0.04, true), settings(), {0, 0});
  periodic.move(motion);
  const MeanFlow sheared = periodic.mean_flow();  // about the middle, along x alone
  EXPECT_DOUBLE_EQ(sheared.slope[0], 0.9 / 0.04);
  EXPECT_EQ(sheared.slope[1], 0.0);
  EXPECT_EQ(sheared.slope[2], 0.0);
  EXPECT_EQ(sheared.origin, 0.0);
  EXPECT_EQ(periodic.cell().shear_velocity, 0.9);
  EXPECT_GT(periodic.mean_flow_speed(6e-3), 6e-3 * (0.9 + 0.03) / 0.04);
  EXPECT_TRUE(periodic.compresses() && periodic.carries());
}

}  // namespace
}  // namespace flowslide::native::boundaries_test
