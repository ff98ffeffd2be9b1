// SPDX-License-Identifier: GPL-2.0-or-later
#include "grains/contact_network.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "cubic_lattice.hpp"

namespace flowslide {
namespace {

using testing::cubic_lattice;

/// 4 n^3 spheres on a face-centred cubic lattice, each in touch with its twelve neighbours.
Assembly densest(int n) {
  Assembly assembly;
  assembly.cell.upper = Vector3::Constant(n);
  assembly.cell.periodic = {true, true, true};
  for (int i = 0; i < n * n * n; ++i)
    for (const Vector3& site : {Vector3(0, 0, 0), Vector3(0, 0.5, 0.5), Vector3(0.5, 0, 0.5), Vector3(0.5, 0.5, 0)}) {
      assembly.resize(assembly.size() + 1);
      assembly.radius.back() = 0.501 * std::sqrt(0.5);
      assembly.position.back() = Vector3(i % n, i / n % n, i / n / n) + site;
    }
  return assembly;
}

TEST(ContactNetwork, CoordinationNumbersOfKnownPackings) {
  EXPECT_EQ(contact_network(cubic_lattice(4, 0.99, true)).coordination_number, 6.0);
  EXPECT_EQ(contact_network(densest(3)).coordination_number, 12.0);
  // Without images: 3 * 2 * 3 * 3 contacts of 27 grains, two ends each.
  EXPECT_EQ(contact_network(cubic_lattice(3, 0.99, false)).coordination_number, 4.0);
  EXPECT_EQ(contact_network(cubic_lattice(3, 1.01, false)).coordination_number, 0.0);
  EXPECT_EQ(contact_network({}).coordination_number, 0.0);
}

TEST(ContactNetwork, CoordinationNumberIsThatOfMobileGrains) {
  Assembly assembly = cubic_lattice(3, 0.99, false);
  for (int i = 0; i < 9; ++i) {
    assembly.role[i] = Role::bottom_layer;
    assembly.role[18 + i] = Role::top_layer;
  }
  // The nine mobile grains have 12 contacts among them (two ends each) and one with each layer.
  EXPECT_DOUBLE_EQ(contact_network(assembly).coordination_number, (24.0 + 18.0) / 9.0);
}

TEST(ContactNetwork, RattlersHaveAtMostOneContact) {
  Assembly assembly = cubic_lattice(4, 0.99, true);
  assembly.radius[0] = 0.1;                     // touches nobody
  assembly.radius[21] = 0.1;                    // nor this one, site (1, 1, 1), ...
  assembly.position[21] += Vector3(0.4, 0, 0);  // ... but for one neighbour
  const ContactNetwork network = contact_network(assembly);
  // Six neighbours of each lose a contact; one of the second's gets it back.
  EXPECT_DOUBLE_EQ(network.rattler_share, 2.0 / 64.0);
  EXPECT_DOUBLE_EQ(network.coordination_number, (64.0 * 6.0 - 24.0 + 2.0) / 64.0);
  EXPECT_DOUBLE_EQ(network.mechanical_coordination_number, (62.0 * 6.0 - 12.0 + 1.0) / 62.0);
  ASSERT_EQ(network.shares.size(), 7U);
  EXPECT_DOUBLE_EQ(network.shares[0], 1.0 / 64.0);
  EXPECT_DOUBLE_EQ(network.shares[1], 1.0 / 64.0);
  EXPECT_DOUBLE_EQ(network.shares[5], 11.0 / 64.0);
  EXPECT_DOUBLE_EQ(network.shares[6], 51.0 / 64.0);
}

TEST(ContactNetwork, FabricOfKnownPackings) {
  EXPECT_NEAR(contact_network(cubic_lattice(4, 0.99, true)).fabric_anisotropy, 0.0, 1e-14);
  Assembly columns = cubic_lattice(4, 0.99, true);
  columns.cell.upper.x() *= 1.5;
  columns.cell.upper.y() *= 1.5;
  for (Vector3& position : columns.position) position = position.cwiseProduct(Vector3(1.5, 1.5, 1.0));
  EXPECT_NEAR(contact_network(columns).fabric_anisotropy, 1.0, 1e-14);
  Assembly sheets = cubic_lattice(4, 0.99, true);  // the deviator is diag(1/6, 1/6, -1/3): sqrt(3/2 * 1/6)
  sheets.cell.upper.z() *= 1.5;
  for (Vector3& position : sheets.position) position.z() *= 1.5;
  EXPECT_NEAR(contact_network(sheets).fabric_anisotropy, 0.5, 1e-14);
}

}  // namespace
}  // namespace flowslide
