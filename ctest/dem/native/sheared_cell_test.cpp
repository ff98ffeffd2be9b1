// SPDX-License-Identifier: GPL-2.0-or-later
// A cell that is periodic along z and sheared across its faces (Lees and Edwards 1972): what must hold whatever the
// law.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>

#include "grains/contact_forces.hpp"
#include "grains/stress.hpp"
#include "same_bits.hpp"
#include "support/clustered_cloud.hpp"

namespace flowslide::sheared_cell_test {
namespace {

constexpr double step = 1e-6, length = 0.0625, faster = 5.0;  // s, m and m/s: 80 /s
const BoundaryMotion shear{Vector3(-0.5 * faster, 0.0, 0.0), Vector3(0.5 * faster, 0.0, 0.0), 0.0, 0.0};

Assembly cloud_in_sheared_cell(double offset, const CloudShape& shape = {.grains = 500, .speed = 0.5}) {
  Cell cell = cube(length, true);
  cell.shear_offset = offset;
  cell.shear_velocity = faster;
  Assembly cloud = clustered_cloud(5, cell, shape);
  for (std::size_t i = 0; i < cloud.size(); ++i)
    cloud.velocity[i].x() += faster / length * cloud.position[i].z();  // the cell lies about the origin
  return cloud;
}

template <typename Real = double>
Assembly sheared(const Assembly& start, int steps, const Material& material = {}) {
  NativeEngine<Real> engine;
  engine.load(start, {material, step, 0.0});
  engine.move(shear);
  engine.run(steps);
  return engine.save();
}

Material frictionless(double restitution) {
  Material m;
  m.restitution = restitution;
  m.sliding_friction = m.rolling_friction = 0.0;
  return m;
}

/// v less the field of the shear.
Vector3 fluctuation(const Assembly& a, std::size_t i) {
  const double centre = 0.5 * (a.cell.lower.z() + a.cell.upper.z());
  return a.velocity[i] - a.cell.shear_velocity / a.cell.height() * (a.position[i].z() - centre) * Vector3::UnitX();
}

TEST(ShearedCell, GrainsThatTouchNobodyFollowTheFieldThroughAllFaces) {
  Assembly far = cloud_in_sheared_cell(0.01, {.grains = 1});
  far.resize(3);
  far.contacts.clear();
  far.position = {Vector3(0.0, 0.0, 0.02), Vector3(0.02, 0.01, -0.02), Vector3(-0.02, -0.02, 0.0)};
  far.radius = {3e-3, 3e-3, 3e-3};
  for (std::size_t i = 0; i < 3; ++i)
    far.velocity[i] = Vector3(faster / length * far.position[i].z(), 0.3, i == 0 ? 1.0 : i == 1 ? -1.0 : 0.0);
  const Assembly after = sheared(far, 200'000);  // 16 strains
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3 line = far.position[i] + 200'000 * step * far.velocity[i];
    // 200 000 additions to numbers below 0.03 m, each rounded to 3e-18 m, and those of the offset, ten times as large.
    EXPECT_LT(after.cell.nearest_image(after.position[i] - line).norm(), 1e-11);
    const Vector3 started = far.velocity[i] - faster / length * line.z() * Vector3::UnitX();
    EXPECT_LT((fluctuation(after, i) - started).norm(), 1e-9);
  }
  EXPECT_NEAR(after.position[2].z(), 0.0, 1e-15);
  EXPECT_LE(std::abs(after.cell.shear_offset), 0.5 * length);
}

TEST(ShearedCell, MomentumIsKeptButForWhatCrossesTheField) {
  const Assembly start = cloud_in_sheared_cell(0.02);
  const Assembly end = sheared(start, 2000);
  Vector3 before = Vector3::Zero(), after = Vector3::Zero(), force = Vector3::Zero();
  double scale = 0.0, forces = 0.0;
  for (std::size_t i = 0; i < start.size(); ++i) {
    const double mass = sphere_mass(start.radius[i], Material{});
    before += mass * fluctuation(start, i);
    after += mass * fluctuation(end, i);
    force += end.force[i];
    forces += end.force[i].norm();
    scale += mass * end.velocity[i].norm() + 2000 * step * end.force[i].norm();
  }
  // d/dt of the sum of m (v_x - rate z) is -rate times the sum of m v_z, which stays.
  before.x() -= 2000 * step * faster / length * before.z();
  EXPECT_LT((after - before).norm(), 1e-12 * scale);
  EXPECT_LT(force.norm(), 1e-13 * forces);
}

template <typename Real>
class ShearedCellOf : public testing::Test {};
using Precisions = testing::Types<double, float>;
TYPED_TEST_SUITE(ShearedCellOf, Precisions);

TYPED_TEST(ShearedCellOf, ForcesAndStressAreThoseOfTheContactLaw) {
  // Of single forces, as in the contract. In float velocities of up to 2.5 m/s are rounded to 1.5e-7 m/s, which
  // dashpots of 2 N s/m make 3e-7 N of, in each of up to ten contacts of a grain; the largest forces are of 0.7 N.
  const double within = std::is_same_v<TypeParam, double> ? 1e-9 : 5e-6;
  Assembly dense = touching_lattice();
  dense.cell.periodic = {true, true, true};
  for (Role& role : dense.role) role = Role::mobile;
  NativeEngine<TypeParam> engine;
  engine.load(dense, {Material{}, step, 0.0});
  engine.move(shear);
  engine.run(900);
  const Assembly now = engine.save();
  const ContactForces forces = evaluate_contact_forces(now, Material{}, step);
  const GrainForces expected = sum_on_grains(forces, now.size());
  double largest = 0.0, error = 0.0;
  std::size_t across = 0;
  for (std::size_t i = 0; i < now.size(); ++i) {
    largest = std::max(largest, now.force[i].norm());
    error = std::max(error, (now.force[i] - expected.force[i]).norm());
    error = std::max(error, (now.torque[i] - expected.torque[i]).norm() / now.radius[i]);
  }
  for (const Contact& contact : forces.contacts)
    across += std::abs((now.position[contact.first] - now.position[contact.second]).z()) > 0.5 * now.cell.height();
  EXPECT_GT(across, 5u);
  EXPECT_LT(error, within * largest);
  const Matrix3 stress = bagi_stress(now, forces);
  const CellStress cheap = engine.cell_stress();
  const double scale = stress.cwiseAbs().maxCoeff();
  EXPECT_NEAR(cheap.normal, stress(2, 2), within * scale);
  EXPECT_NEAR(cheap.shear, -stress(2, 0), within * scale);
  EXPECT_NEAR(cheap.transverse, -stress(2, 1), within * scale);
  EXPECT_NEAR(cheap.lateral_x, stress(0, 0), within * scale);
  EXPECT_NEAR(cheap.lateral_y, stress(1, 1), within * scale);
  NativeEngine<TypeParam> again;  // tells it before a step as well
  again.load(now, {Material{}, step, 0.0});
  EXPECT_NEAR(again.cell_stress().shear, cheap.shear, within * scale);
  EXPECT_NEAR(again.cell_stress().normal, cheap.normal, within * scale);
}

TYPED_TEST(ShearedCellOf, AnOffsetOfWholePeriodsIsNone) {
  const Assembly start = cloud_in_sheared_cell(0.015625);
  Assembly further = start;
  further.cell.shear_offset += 2.0 * length;
  expect_same_bits(sheared<TypeParam>(start, 500), sheared<TypeParam>(further, 500));
}

TEST(ShearedCell, IsTheSameSeenFromAnotherHeight) {
  const Assembly start = cloud_in_sheared_cell(0.01);
  Assembly higher = start;
  for (std::size_t i = 0; i < start.size(); ++i) {  // some leave the cell, and are folded when it is loaded
    higher.position[i].z() += 0.4 * length;
    higher.velocity[i].x() += 0.4 * faster;
  }
  const Assembly one = sheared(start, 200), other = sheared(higher, 200);
  double largest = 0.0, error = 0.0;
  for (std::size_t i = 0; i < start.size(); ++i) {
    largest = std::max(largest, one.force[i].norm());
    error = std::max(error, (one.force[i] - other.force[i]).norm());
  }
  EXPECT_LT(error, 1e-8 * largest);  // positions differ by 1e-17 m against overlaps of 1e-6 m, and 200 steps
}

TEST(ShearedCell, AChangeOfRateIsTheSameAtEveryHeight) {
  const Assembly start = cloud_in_sheared_cell(0.01);
  DoubleEngine engine;
  engine.load(start, {Material{}, step, 0.0});
  const BoundaryMotion twice{Vector3(-faster, 0.0, 0.0), Vector3(faster, 0.0, 0.0), 0.0, 0.0};
  engine.move(twice);
  const Assembly changed = engine.save();
  EXPECT_EQ(changed.cell.shear_velocity, 2.0 * faster);
  // The fluctuations stay: no face drives the sample.
  for (std::size_t i = 0; i < start.size(); ++i)
    EXPECT_LT((fluctuation(changed, i) - fluctuation(start, i)).norm(), 1e-14);
  DoubleEngine sliding;  // goes on as it was loaded until it is told otherwise
  sliding.load(start, {Material{}, step, 0.0});
  sliding.run(100);
  expect_same_bits(sliding.save(), sheared(start, 100));
}

/// Of motion about the field, and of the springs, J.
double energy(const Assembly& a, const Material& material) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    sum += 0.5 * sphere_mass(a.radius[i], material) * fluctuation(a, i).squaredNorm();
  for (const Contact& contact : evaluate_contact_forces(a, material, 0.0).contacts) {
    const PairConstants c = pair_constants(material, a.radius[contact.first], a.radius[contact.second]);
    sum += 8.0 / 15.0 * c.effective_modulus * std::sqrt(c.effective_radius) * std::pow(contact.overlap, 2.5);
  }
  return sum;
}

/// Power, W: of the shear on contacts and on fluctuations, and what dashpots take.
std::array<double, 2> powers(const Engine& engine, const Material& material) {
  const Assembly a = engine.save();
  double shearing = engine.cell_stress().shear * a.cell.volume(), taken = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Vector3 v = fluctuation(a, i);
    shearing -= sphere_mass(a.radius[i], material) * v.x() * v.z();
  }
  const double rate = a.cell.shear_velocity / a.cell.height(), time_step = engine.settings().time_step;
  if (material.restitution == 1.0) return {rate * shearing, 0.0};
  const ContactForces with = evaluate_contact_forces(a, material, time_step);
  const ContactForces without = evaluate_contact_forces(a, frictionless(1.0), time_step);
  for (std::size_t c = 0; c < with.contacts.size(); ++c) {
    const Contact& contact = with.contacts[c];
    const Vector3 approach = a.velocity[contact.first] - a.velocity[contact.second] -
                             a.cell.nearest_image_velocity(a.position[contact.first] - a.position[contact.second]);
    taken -= (contact.force.on_first - without.contacts[c].force.on_first).dot(approach);
  }
  return {rate * shearing, taken};
}

/// Work of the shear, energy that is gained, and what dashpots took in 0.4 ms, J.
std::array<double, 3> balance(double time_step, double restitution) {
  const Material material = frictionless(restitution);
  const CloudShape shape{.grains = 300, .overlap = 0.002, .speed = 0.2, .spin = 0.0, .spring = 0.0, .torque = 0.0};
  Assembly start = cloud_in_sheared_cell(0.02, shape);
  start.contacts.clear();
  start.force = sum_on_grains(evaluate_contact_forces(start, material, 0.0), start.size()).force;
  DoubleEngine engine;
  engine.load(start, {material, time_step, 0.0});
  engine.move(shear);
  double work = 0.0, taken = 0.0;
  std::array<double, 2> before = powers(engine, material);
  const int steps = static_cast<int>(std::lround(4e-4 / time_step));
  for (int s = 0; s < steps; ++s) {
    engine.run(1);
    const std::array<double, 2> now = powers(engine, material);
    work += 0.5 * time_step * (before[0] + now[0]);
    taken += 0.5 * time_step * (before[1] + now[1]);
    before = now;
  }
  return {work, energy(engine.save(), material) - energy(start, material), taken};
}

TEST(ShearedCell, WorkOfTheShearIsGainedToSecondOrderOrTakenByDashpots) {
  double coarser = 0.0;
  for (const double time_step : {2e-6, 1e-6}) {
    const auto [work, gained, none] = balance(time_step, 1.0);
    const double error = std::abs(work - gained);
    std::printf("step %g s: work %.6g J, gained %.6g J, differ by %.2g J\n", time_step, work, gained, error);
    EXPECT_GT(std::abs(gained), 50.0 * error);
    if (coarser > 0.0) {
      EXPECT_LT(error, coarser / 3.0);
    }
    coarser = error;
  }
  // Dashpots see the velocities of the half step, which makes it first order: 1e-6 s against contacts of 1e-4 s.
  const auto [work, gained, taken] = balance(1e-6, 0.5);
  std::printf("with dashpots: work %.6g J, gained %.6g J, taken %.6g J\n", work, gained, taken);
  EXPECT_LT(std::abs(work - gained - taken), 0.03 * taken);
}

TEST(ShearedCell, RefusesFacesThatHaveNothingToSlideOver) {
  Assembly start = cloud_in_sheared_cell(0.0);
  DoubleEngine engine;
  engine.load(start, {Material{}, step, 0.0});
  EXPECT_THROW(engine.move({Vector3::Zero(), Vector3(1.0, 0.1, 0.0), 0.0, 0.0}), EngineError);
  for (const std::size_t axis : {0u, 2u}) {
    Assembly rigid = start;
    rigid.cell.periodic[axis] = false;
    EXPECT_THROW(engine.load(rigid, {Material{}, step, 0.0}), EngineError);
  }
  start.cell.periodic[0] = false;
  start.cell.shear_velocity = 0.0;
  engine.load(start, {Material{}, step, 0.0});
  EXPECT_THROW(engine.move(shear), EngineError);
}

}  // namespace
}  // namespace flowslide::sheared_cell_test
