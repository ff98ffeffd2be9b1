// SPDX-License-Identifier: GPL-2.0-or-later
#include "grains/slab_stress.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "grains/stress.hpp"
#include "support/touching_lattice.hpp"

namespace flowslide {
namespace {

/// Two grains above each other at z = 1 and z = 3 m in a cell of 2 m^2 x 4 m that press with 5 N.
struct Column {
  Assembly assembly;
  ContactForces forces;
  Column() {
    assembly.cell.upper = {1.0, 2.0, 4.0};
    assembly.resize(2);
    assembly.radius = {1.0, 1.0};
    assembly.position = {{0.5, 1.0, 1.0}, {0.5, 1.0, 3.0}};
    Contact contact;
    contact.first = 0;
    contact.second = 1;
    contact.branch = {0.0, 0.0, -2.0};
    contact.force.on_first = {0.0, 0.0, -5.0};
    forces.contacts.push_back(contact);
  }
};

TEST(SlabStress, InsideTheBranchItIsForceOverArea) {
  const Column c;
  EXPECT_DOUBLE_EQ(slab_stress(c.assembly, c.forces, 1.5, 2.5)(2, 2), 5.0 / 2.0);
}

TEST(SlabStress, OutsideTheBranchThereIsNone) {
  const Column c;
  EXPECT_DOUBLE_EQ(slab_stress(c.assembly, c.forces, 3.1, 4.0)(2, 2), 0.0);
  EXPECT_DOUBLE_EQ(slab_stress(c.assembly, c.forces, 2.5, 3.5)(2, 2), 0.5 * 5.0 / 2.0);
}

TEST(SlabStress, SlabsAddUpToTheWholeCell) {
  Assembly assembly = touching_lattice(4, 6);
  for (Vector3& v : assembly.velocity) v.setZero();
  const ContactForces forces = evaluate_contact_forces(assembly, Material{}, 0.0);
  const double height = assembly.cell.height();
  const Matrix3 whole = slab_stress(assembly, forces, 0.0, height);
  Matrix3 mean = Matrix3::Zero();
  for (int k = 0; k < 10; ++k) mean += 0.1 * slab_stress(assembly, forces, 0.1 * k * height, 0.1 * (k + 1) * height);
  // The same terms, divided and summed again: rounding.
  EXPECT_LT((mean - whole).norm(), 1e-12 * whole.norm());
}

TEST(SlabStress, AllOfACellThatIsPeriodicAlongZIsBulk) {
  Assembly assembly = touching_lattice(4, 6);
  assembly.cell.periodic[2] = true;
  assembly.cell.shear_offset = 1e-4;
  for (Role& role : assembly.role) role = Role::mobile;
  const ContactForces forces = evaluate_contact_forces(assembly, Material{}, 0.0);
  const Matrix3 virial = bagi_stress(assembly, forces);
  EXPECT_LT((bulk_stress(assembly, forces) - virial).norm(), 1e-12 * virial.norm());
  const double height = assembly.cell.height();
  Matrix3 mean = Matrix3::Zero();
  for (int k = 0; k < 10; ++k) mean += 0.1 * slab_stress(assembly, forces, 0.1 * k * height, 0.1 * (k + 1) * height);
  EXPECT_LT((mean - virial).norm(), 1e-12 * virial.norm());
}

TEST(SlabStress, BulkOfAUniformLatticeIsTheStressOfItsSections) {
  Assembly assembly = touching_lattice(4, 8);
  for (std::size_t i = 0; i < assembly.size(); ++i) {  // a perfect lattice
    assembly.velocity[i].setZero();
    assembly.spin[i].setZero();
    assembly.radius[i] = 3e-3;
    assembly.position[i] =
        5.988e-3 * ((assembly.position[i] / 5.988e-3 - Vector3::Constant(0.5)).array().round() + 0.5);
  }
  const ContactForces forces = evaluate_contact_forces(assembly, Material{}, 0.0);
  const Matrix3 bagi = bagi_stress(assembly, forces), bulk = bulk_stress(assembly, forces);
  EXPECT_NEAR(bulk(2, 2), bagi(2, 2), 1e-9 * bagi(2, 2));
  EXPECT_GT(bulk(2, 2), 0.0);
}

TEST(SlabStress, RefusesASlabWithoutThickness) {
  const Column c;
  EXPECT_THROW(slab_stress(c.assembly, c.forces, 2.0, 2.0), std::invalid_argument);
}

}  // namespace
}  // namespace flowslide
