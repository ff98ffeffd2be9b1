// SPDX-License-Identifier: GPL-2.0-or-later
#include "grains/bulk_mean_stress.hpp"

#include <gtest/gtest.h>

#include "grains/kinetic_stress.hpp"
#include "grains/slab_stress.hpp"
#include "support/touching_lattice.hpp"

namespace flowslide {
namespace {

TEST(BulkMeanStress, IsThatOfTheBulkAndOfItsMotion) {
  const Assembly assembly = touching_lattice();
  const ContactForces forces = evaluate_contact_forces(assembly, Material{}, 0.0);
  const double contacts = bulk_stress(assembly, forces).trace() / 3.0;
  const double motion = kinetic_stress(assembly, Material{}).trace() / 3.0;
  EXPECT_GT(contacts, 1e3);
  EXPECT_GT(motion, 0.0);
  EXPECT_NEAR(bulk_mean_stress(assembly, forces, Material{}), contacts + motion, 1e-12 * contacts);  // rounding
}

TEST(BulkMeanStress, StaysAboveZeroWithoutContacts) {
  Assembly gas = touching_lattice();
  for (double& radius : gas.radius) radius *= 0.9;
  const ContactForces none = evaluate_contact_forces(gas, Material{}, 0.0);
  EXPECT_GT(bulk_mean_stress(gas, none, Material{}), 0.0);
}

TEST(BulkMeanStress, DashpotsThatPullCountAsNothing) {
  Assembly receding = touching_lattice();
  for (std::size_t i = 0; i < receding.size(); ++i) receding.velocity[i].z() = 1e4 * receding.position[i].z();
  const ContactForces forces = evaluate_contact_forces(receding, Material{}, 0.0);
  ASSERT_LT(bulk_stress(receding, forces).trace(), 0.0);
  const double motion = kinetic_stress(receding, Material{}).trace() / 3.0;
  EXPECT_NEAR(bulk_mean_stress(receding, forces, Material{}), motion, 1e-12 * motion);  // rounding
}

}  // namespace
}  // namespace flowslide
