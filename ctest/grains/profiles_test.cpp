// SPDX-License-Identifier: GPL-2.0-or-later
#include "grains/profiles.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <stdexcept>

#include "grains/slab_stress.hpp"
#include "grains/stress.hpp"
#include "support/touching_lattice.hpp"

namespace flowslide::profiles_test {
namespace {

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// A lattice whose cell does not begin at z = 0, sheared at 3 1/s.
Assembly sheared() {
  Assembly assembly = touching_lattice(6, 10);
  for (std::size_t i = 0; i < assembly.size(); ++i) assembly.velocity[i] = {3.0 * assembly.position[i].z(), 0.0, 0.0};
  for (Vector3& position : assembly.position) position.z() -= 0.5;
  assembly.cell.lower.z() -= 0.5;
  assembly.cell.upper.z() -= 0.5;
  return assembly;
}

TEST(Profiles, VelocityOfSimpleShearIsLinear) {
  const Assembly assembly = sheared();
  const Profiles found = profiles(assembly, evaluate_contact_forces(assembly, Material{}, 0.0), 10);
  ASSERT_EQ(found.velocity.size(), 10U);
  for (std::size_t layer = 0; layer < 10; ++layer) {
    EXPECT_NEAR(found.height[layer], (static_cast<double>(layer) + 0.5) * assembly.cell.height() / 10.0, 1e-12);
    // Ten layers of grains in ten sublayers: each has its own, out of place by 0.1 % of a diameter at most.
    EXPECT_NEAR(found.velocity[layer], 3.0 * found.height[layer], 3.0 * 2e-3 * 6e-3);
  }
}

TEST(Profiles, VelocityOfACellShearedAcrossItsFacesIsThatAboveTheLowerOne) {
  Assembly assembly = sheared();
  assembly.cell.periodic[2] = true;
  assembly.cell.shear_velocity = 3.0 * assembly.cell.height();
  for (Role& role : assembly.role) role = Role::mobile;
  const double middle = 0.5 * (assembly.cell.lower.z() + assembly.cell.upper.z());
  for (std::size_t i = 0; i < assembly.size(); ++i) {
    assembly.position[i].z() += 2e-3;  // the last layer pokes through the upper face, and in at the lower
    assembly.velocity[i] = {3.0 * (assembly.position[i].z() - middle), 0.0, 0.0};
  }
  const Profiles found = profiles(assembly, evaluate_contact_forces(assembly, Material{}, 0.0), 5);
  // Of the solid's mean height in a sublayer, which is not its middle: less than half a radius off.
  for (std::size_t layer = 0; layer < 5; ++layer)
    EXPECT_NEAR(found.velocity[layer], 3.0 * found.height[layer], 3.0 * 1.5e-3);
}

TEST(Profiles, OfOneSublayerAreTheWhole) {
  const Assembly assembly = sheared();
  const ContactForces forces = evaluate_contact_forces(assembly, Material{}, 0.0);
  const Profiles whole = profiles(assembly, forces, 1), parts = profiles(assembly, forces, 7);
  const SlopeStress stress =
      slope_stress(slab_stress(assembly, forces, assembly.cell.lower.z(), assembly.cell.upper.z()));
  EXPECT_EQ(whole.shear_stress.front(), stress.shear);
  EXPECT_EQ(whole.normal_stress.front(), stress.normal);
  // Equal slabs: the mean over them is the whole. Rounding.
  EXPECT_NEAR(mean(parts.shear_stress), stress.shear, 1e-12 * std::abs(stress.normal));
  EXPECT_NEAR(mean(parts.normal_stress), stress.normal, 1e-12 * std::abs(stress.normal));
}

TEST(Profiles, ShearBearsOnEverySublayerOfTheBulk) {
  const Assembly assembly = sheared();
  const Profiles found = profiles(assembly, evaluate_contact_forces(assembly, Material{}, 0.0), 5);
  for (std::size_t layer = 1; layer < 4; ++layer) EXPECT_GT(found.normal_stress[layer], 1e3);
}

TEST(Profiles, RefuseSublayersThatHoldNothing) {
  const Assembly assembly = sheared();
  const ContactForces none;
  EXPECT_THROW(profiles(assembly, none, 0), std::invalid_argument);
  Assembly hollow = assembly;
  for (Vector3& position : hollow.position) position.z() = -0.49;
  EXPECT_THROW(profiles(hollow, none, 10), std::invalid_argument);
}

}  // namespace
}  // namespace flowslide::profiles_test
