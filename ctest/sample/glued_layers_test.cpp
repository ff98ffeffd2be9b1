// SPDX-License-Identifier: GPL-2.0-or-later
#include "sample/glued_layers.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "sample/failure.hpp"
#include "support/touching_lattice.hpp"

namespace flowslide {
namespace {

Assembly all_mobile() {
  Assembly assembly = touching_lattice(4, 5);
  std::fill(assembly.role.begin(), assembly.role.end(), Role::mobile);
  return assembly;
}

TEST(GluedLayers, GluesTheGrainsAtThePlanesAndNoOther) {
  Assembly assembly = all_mobile();
  glue_layers(assembly, Glue::one_layer);
  EXPECT_EQ(assembly.role, touching_lattice(4, 5).role);
}

TEST(GluedLayers, GluesTheGrainsWhoseCentreLiesInTheOuterShare) {
  Assembly assembly = all_mobile();
  const Cell& cell = assembly.cell;
  // One centre just inside and one just outside of 5 % at each end; the others at mid-height.
  const double share = 0.05 * cell.height(), mid = 0.5 * (cell.lower.z() + cell.upper.z());
  for (Vector3& position : assembly.position) position.z() = mid;
  assembly.position[0].z() = cell.lower.z() + 0.99 * share;
  assembly.position[1].z() = cell.lower.z() + 1.01 * share;
  assembly.position[2].z() = cell.upper.z() - 0.99 * share;
  assembly.position[3].z() = cell.upper.z() - 1.01 * share;
  glue_layers(assembly, Glue::outer_share);
  EXPECT_EQ(assembly.role[0], Role::bottom_layer);
  EXPECT_EQ(assembly.role[2], Role::top_layer);
  for (std::size_t i = 0; i < assembly.size(); ++i)
    if (i != 0 && i != 2) {
      EXPECT_EQ(assembly.role[i], Role::mobile) << i;
    }
  EXPECT_NEAR(layer_thickness(assembly).bottom, 0.99 * share, 1e-15);
  EXPECT_NEAR(layer_thickness(assembly).top, 0.99 * share, 1e-15);
}

TEST(GluedLayers, AreAsThickAsTheirInnermostCentreIsDeep) {
  EXPECT_EQ(layer_thickness(all_mobile()).bottom, 0.0);
  const Assembly lattice = touching_lattice(4, 5);
  double bottom = 0.0;
  for (std::size_t i = 0; i < lattice.size(); ++i)
    if (lattice.role[i] == Role::bottom_layer)
      bottom = std::max(bottom, lattice.position[i].z() - lattice.cell.lower.z());
  EXPECT_GT(bottom, 0.0);
  EXPECT_EQ(layer_thickness(lattice).bottom, bottom);
}

TEST(GluedLayers, StopsThemAndForgetsTheirContactsWithEachOther) {
  Assembly assembly = all_mobile();
  for (Vector3& velocity : assembly.velocity) velocity = {1.0, 2.0, 3.0};
  assembly.contacts = {{0, 1, Vector3::Ones(), Vector3::Ones()}, {0, 16, Vector3::Ones(), Vector3::Ones()}};
  glue_layers(assembly, Glue::one_layer);
  EXPECT_EQ(assembly.velocity[0], Vector3::Zero());
  EXPECT_EQ(assembly.velocity[16], Vector3(1.0, 2.0, 3.0));
  ASSERT_EQ(assembly.contacts.size(), 1u);
  EXPECT_EQ(assembly.contacts[0].second, 16u);
}

TEST(GluedLayers, RefusesACellThatIsTooLowOrNotFull) {
  Assembly low = all_mobile();
  for (double& radius : low.radius) radius *= 8.0;  // each grain reaches both planes
  EXPECT_THROW(glue_layers(low, Glue::one_layer), NumericalFailure);
  Assembly slack = all_mobile();
  slack.cell.upper.z() += 0.01;
  EXPECT_THROW(glue_layers(slack, Glue::one_layer), NumericalFailure);
  EXPECT_THROW(glue_layers(slack, Glue::outer_share), NumericalFailure);
}

}  // namespace
}  // namespace flowslide
