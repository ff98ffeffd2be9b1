// SPDX-License-Identifier: GPL-2.0-or-later
#include "grains/stress.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "grains/contact_search.hpp"
#include "random_assembly.hpp"
#include "section_stress.hpp"

namespace flowslide::stress_test {
namespace {

using testing::force_on_mobile;
using testing::random_cloud;
using testing::section_stress;
using testing::uniform_vector;

const Vector3 zero = Vector3::Zero();

/// Grains of radius 1 m in a cell of 2 x 3 x `height` with rigid z, at heights `z`; nothing else is set.
Assembly column(double height, const std::vector<double>& z) {
  Assembly assembly;
  assembly.resize(z.size());
  assembly.cell.lower = Vector3(0.0, 0.0, 5.0);
  assembly.cell.upper = Vector3(2.0, 3.0, 5.0 + height);
  assembly.cell.periodic = {true, true, false};
  for (std::size_t i = 0; i < z.size(); ++i) {
    assembly.radius[i] = 1.0;
    assembly.position[i] = Vector3(1.0, 1.0, 5.0 + z[i]);
  }
  return assembly;
}

/// A contact with a made-up force on `first`.
Contact contact(const Assembly& assembly, std::uint32_t first, std::uint32_t second, const Vector3& on_first) {
  Contact result;
  result.first = first;
  result.second = second;
  result.branch = assembly.cell.nearest_image(assembly.position[first] - assembly.position[second]);
  result.force.on_first = on_first;
  return result;
}

PlaneContact plane_contact(const Assembly& assembly, std::uint32_t grain, bool upper, double force) {
  PlaneContact result;
  result.grain = grain;
  result.axis = 2;
  result.upper = upper;
  const double plane = upper ? assembly.cell.upper.z() : assembly.cell.lower.z();
  result.point_from_grain = Vector3::UnitZ() * (plane - assembly.position[grain].z());
  result.force_on_grain = Vector3::UnitZ() * force;
  return result;
}

void set_forces(Assembly& assembly, const ContactForces& forces) {
  assembly.force = sum_on_grains(forces, assembly.size()).force;
}

void expect_near(const Matrix3& value, const Matrix3& expected, double tolerance) {
  EXPECT_LE((value - expected).cwiseAbs().maxCoeff(), tolerance) << "value\n" << value << "\nexpected\n" << expected;
}

TEST(BagiStress, OfTwoGrains) {
  Assembly pair = column(4.0, {1.0, 2.5});
  pair.position[1].x() += 0.5;
  ContactForces forces;
  forces.contacts.push_back(contact(pair, 0, 1, Vector3(-3.0, 6.0, -12.0)));
  // l = (-0.5, 0, -1.5), V = 24.
  Matrix3 expected;
  expected << 1.5, -3.0, 6.0, 0.0, 0.0, 0.0, 4.5, -9.0, 18.0;
  expect_near(bagi_stress(pair, forces), expected / 24.0, 1e-15);
}

TEST(BagiStress, OfAGrainPressedBetweenThePlanes) {
  Assembly grain = column(1.9, {0.95});
  ContactForces forces;
  forces.plane_contacts = {plane_contact(grain, 0, false, 12.0), plane_contact(grain, 0, true, -12.0)};
  set_forces(grain, forces);
  // Force over area, 12 / 6, whatever the height.
  expect_near(bagi_stress(grain, forces), Vector3(0, 0, 2.0).asDiagonal(), 1e-14);
  EXPECT_EQ(force_on_mobile(grain, forces, Role::top_layer), Vector3(0, 0, -12.0));
  EXPECT_NEAR(section_stress(grain, force_on_mobile(grain, forces, Role::top_layer)).z(), 2.0, 1e-14);
}

TEST(BagiStress, OfAGrainThrownUpByTheBottom) {
  Assembly grain = column(4.0, {0.9});
  ContactForces forces;
  forces.plane_contacts = {plane_contact(grain, 0, false, 12.0)};
  set_forces(grain, forces);
  // The plane acts over 0.9 of 4 m: 12 / 6 * 0.9 / 4.
  expect_near(bagi_stress(grain, forces), Vector3(0, 0, 0.45).asDiagonal(), 1e-15);
  EXPECT_NEAR(section_stress(grain, zero).z(), 0.45, 1e-15);
}

TEST(BagiStress, OfABalancedChainBetweenTheLayersIsForceOverArea) {
  // Each contact hands the force on; where the grains stand does not matter: the branches add up to the height.
  Assembly chain = column(6.0, {0.4, 1.9, 3.3, 4.1, 5.7});
  chain.role.front() = Role::bottom_layer;
  chain.role.back() = Role::top_layer;
  chain.position[2].y() += 0.7;
  chain.position[3].x() -= 0.4;
  const Vector3 force(1.2, -0.6, -6.0);  // on the lower one: the upper ones press down and drag towards +x
  ContactForces forces;
  for (std::uint32_t i = 0; i < 4; ++i) forces.contacts.push_back(contact(chain, i, i + 1, force));
  set_forces(chain, forces);
  for (const int i : {1, 2, 3}) EXPECT_EQ(chain.force[i], zero);
  const Matrix3 stress = bagi_stress(chain, forces);
  EXPECT_LE((stress.row(2) - Vector3(-0.2, 0.1, 1.0).transpose()).norm(), 1e-14);  // -force / 6
  const SlopeStress slope = slope_stress(stress);
  EXPECT_NEAR(slope.normal, 1.0, 1e-14);
  EXPECT_NEAR(slope.shear, 0.2, 1e-14);  // dragged by the top towards +x: positive
  EXPECT_NEAR(slope.mean, stress.trace() / 3.0, 1e-15);
}

TEST(BagiStress, OfAPeriodicCubicLatticeIsThePressure) {
  // One force of 5 N through each face of 2 x 2 m between the grains of a 3 x 3 x 3 lattice: 1.25 Pa on all faces.
  Assembly lattice;
  lattice.resize(27);
  lattice.cell.upper = Vector3::Constant(6.0);
  lattice.cell.periodic = {true, true, true};
  ContactForces forces;
  const auto index = [](int i, int j, int k) { return static_cast<std::uint32_t>(i % 3 + 3 * (j % 3) + 9 * (k % 3)); };
  for (int n = 0; n < 27; ++n) lattice.position[n] = 2.0 * Vector3(n % 3, n / 3 % 3, n / 9);
  for (int k = 0; k < 3; ++k)
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i) {
        forces.contacts.push_back(contact(lattice, index(i + 1, j, k), index(i, j, k), 5.0 * Vector3::UnitX()));
        forces.contacts.push_back(contact(lattice, index(i, j + 1, k), index(i, j, k), 5.0 * Vector3::UnitY()));
        forces.contacts.push_back(contact(lattice, index(i, j, k + 1), index(i, j, k), 5.0 * Vector3::UnitZ()));
      }
  expect_near(bagi_stress(lattice, forces), 1.25 * Matrix3::Identity(), 1e-14);
}

TEST(BagiStress, SectionRowEqualsTheFormWithoutPairs) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Assembly cloud = random_cloud(seed, 150, Vector3(0.03, 0.025, 0.035), {true, true, false});
    testing::glue_layers(cloud, 0.006);
    const ContactForces forces = evaluate_contact_forces(cloud, Material{}, 5e-7);
    set_forces(cloud, forces);  // far from equilibrium
    const Matrix3 bagi = bagi_stress(cloud, forces);
    const Vector3 section = section_stress(cloud, force_on_mobile(cloud, forces, Role::top_layer));
    EXPECT_LE((bagi.row(2).transpose() - section).norm(), 1e-12 * bagi.norm()) << "seed " << seed;  // rounding
  }
}

TEST(BagiStress, BesidePlanesOfXSectionsAgreeInAllButTheZxComponent) {
  Assembly cloud = random_cloud(4, 100, Vector3(0.03, 0.03, 0.03), {false, true, false});
  const ContactForces forces = evaluate_contact_forces(cloud, Material{}, 5e-7);
  set_forces(cloud, forces);
  EXPECT_GT(forces.plane_contacts.size(), 20u);
  const Matrix3 bagi = bagi_stress(cloud, forces);
  const Vector3 section = section_stress(cloud, force_on_mobile(cloud, forces, Role::top_layer));
  EXPECT_NEAR(bagi(2, 2), section.z(), 1e-12 * bagi.norm());  // rounding
  EXPECT_NEAR(bagi(2, 1), section.y(), 1e-12 * bagi.norm());  // y is periodic
  // The planes of x add sum z f_x to the force on the grains but nothing to Bagi's zx.
  double of_planes = 0.0;
  for (const PlaneContact& plane : forces.plane_contacts)
    of_planes += (cloud.position[plane.grain].z() - cloud.cell.lower.z()) * plane.force_on_grain.x();
  EXPECT_NEAR(bagi(2, 0), section.x() - of_planes / cloud.cell.volume(), 1e-12 * bagi.norm());
}

TEST(BagiStress, TurnsWithTheAssemblyAndDoesNotShiftWithIt) {
  std::mt19937_64 generator(5);
  Assembly cloud = random_cloud(5, 60, Vector3(0.03, 0.03, 0.03), {false, false, false});
  cloud.cell.lower -= Vector3::Constant(0.1);  // planes out of reach
  cloud.cell.upper += Vector3::Constant(0.1);
  const Matrix3 stress = bagi_stress(cloud, evaluate_contact_forces(cloud, Material{}, 5e-7));
  const Matrix3 turn = Eigen::AngleAxisd(1.0, uniform_vector(generator, 1.0).normalized()).toRotationMatrix();
  const Vector3 shift = uniform_vector(generator, 0.02);
  const Vector3 centre = 0.5 * (cloud.cell.lower + cloud.cell.upper);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    cloud.position[i] = centre + shift + turn * (cloud.position[i] - centre);
    for (auto* array : {&cloud.velocity, &cloud.spin, &cloud.force, &cloud.torque}) (*array)[i] = turn * (*array)[i];
  }
  const Matrix3 turned = bagi_stress(cloud, evaluate_contact_forces(cloud, Material{}, 5e-7));
  EXPECT_GT(stress.norm(), 0.0);
  // Random overlaps are of the order of R, so rounding of the positions does not grow.
  expect_near(turned, turn * stress * turn.transpose(), 1e-12 * stress.norm());
}

TEST(BagiStress, OfSpringsThatTheTopDragsIsStiffnessTimesSpringOverArea) {
  // A mobile grain between two glued ones, overlap 1e-5 m; the upper surfaces moved by 1e-8 m towards +x.
  const Material material;
  Assembly grains = column(0.012, {0.0, 0.00599, 0.01198});
  grains.cell.upper = Vector3(0.01, 0.01, 5.012);
  grains.radius.assign(3, 3e-3);
  grains.role = {Role::bottom_layer, Role::mobile, Role::top_layer};
  for (Vector3& position : grains.position) position.head<2>().setConstant(0.005);
  const Vector3 spring(1e-8, 0.0, 0.0);
  grains.contacts = {{0, 1, -spring, zero}, {1, 2, -spring, zero}};
  const ContactForces forces = evaluate_contact_forces(grains, material, 5e-7);
  ASSERT_EQ(forces.contacts.size(), 2u);
  const PairConstants pair = pair_constants(material, 3e-3, 3e-3);
  const double stiffness = 8.0 * pair.effective_shear_modulus * std::sqrt(1.5e-3 * 1e-5);
  const SlopeStress stress = slope_stress(bagi_stress(grains, forces));
  // Area 1e-4 m^2. The overlap of 1e-5 m is known to the rounding of z = 5 m: 1e-15 / 1e-5.
  EXPECT_NEAR(stress.shear, stiffness * 1e-8 / 1e-4, 1e-9 * stress.shear);
  EXPECT_NEAR(stress.normal, normal_force(material, pair, 1e-5, 0.0) / 1e-4, 1e-9 * stress.normal);
}

TEST(NicotStress, IsBagisWithoutSpinsAndTorques) {
  Assembly cloud = random_cloud(6, 100, Vector3(0.03, 0.03, 0.03), {true, true, true});
  const ContactForces forces = evaluate_contact_forces(cloud, Material{}, 5e-7);
  for (std::size_t i = 0; i < cloud.size(); ++i) cloud.spin[i] = cloud.torque[i] = zero;
  EXPECT_EQ(nicot_stress(cloud, forces, Material{}), bagi_stress(cloud, forces));
}

TEST(NicotCorrection, OfASpinningGrainIsItsCentrifugalTension) {
  Assembly grain = column(4.0, {2.0});
  grain.spin[0] = Vector3(0.0, 0.0, 3.0);
  Material material;
  material.density = 10.0 * 0.75 / 3.14159265358979323846;  // 10 kg at R = 1 m
  // chi = 10 / 5; -2 * 9 / 24 along x and y, nothing along the axis.
  expect_near(nicot_correction(grain, material), Vector3(-0.75, -0.75, 0.0).asDiagonal(), 1e-14);
  grain.role[0] = Role::top_layer;
  EXPECT_EQ(nicot_correction(grain, material), Matrix3(Matrix3::Zero()));
}

TEST(NicotCorrection, OfAnAcceleratingGrainIsHalfItsTorque) {
  Assembly grain = column(4.0, {2.0});
  grain.torque[0] = Vector3(0.0, 0.0, 48.0);
  // chi alpha_k eps_kij = T_k eps_kij / 2, independent of the mass: entry xy is 48 / 2 / 24.
  Matrix3 expected = Matrix3::Zero();
  expected(0, 1) = 1.0;
  expected(1, 0) = -1.0;
  expect_near(nicot_correction(grain, Material{}), expected, 1e-14);
}

TEST(NicotStress, IsSymmetricWhereBagisIsNot) {
  Assembly cloud = random_cloud(7, 120, Vector3(0.03, 0.03, 0.03), {true, true, false});
  std::mt19937_64 generator(7);
  for (const auto& [i, j] : touching_pairs(cloud))  // springs up to their caps
    cloud.contacts.push_back({i, j, uniform_vector(generator, 1e-3), uniform_vector(generator, 1.0)});
  const ContactForces forces = evaluate_contact_forces(cloud, Material{}, 5e-7);
  cloud.torque = sum_on_grains(forces, cloud.size()).torque;
  const Matrix3 bagi = bagi_stress(cloud, forces), nicot = nicot_stress(cloud, forces, Material{});
  EXPECT_GT((bagi - bagi.transpose()).norm(), 1e-3 * bagi.norm());
  expect_near(nicot, nicot.transpose(), 1e-13 * bagi.norm());
}

TEST(SlopeStress, Signs) {
  Matrix3 stress;
  stress << 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0;
  const SlopeStress slope = slope_stress(stress);
  EXPECT_EQ(slope.normal, 9.0);
  EXPECT_EQ(slope.shear, -7.0);
  EXPECT_EQ(slope.mean, 5.0);
}

}  // namespace
}  // namespace flowslide::stress_test
