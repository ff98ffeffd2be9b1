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
  glue_layers(assembly, 1e-4);
  EXPECT_EQ(assembly.role, touching_lattice(4, 5).role);
}

TEST(GluedLayers, StopsThemAndForgetsTheirContactsWithEachOther) {
  Assembly assembly = all_mobile();
  for (Vector3& velocity : assembly.velocity) velocity = {1.0, 2.0, 3.0};
  assembly.contacts = {{0, 1, Vector3::Ones(), Vector3::Ones()}, {0, 16, Vector3::Ones(), Vector3::Ones()}};
  glue_layers(assembly, 1e-4);
  EXPECT_EQ(assembly.velocity[0], Vector3::Zero());
  EXPECT_EQ(assembly.velocity[16], Vector3(1.0, 2.0, 3.0));
  ASSERT_EQ(assembly.contacts.size(), 1u);
  EXPECT_EQ(assembly.contacts[0].second, 16u);
}

TEST(GluedLayers, RefusesACellThatIsTooLowOrNotFull) {
  Assembly low = all_mobile();
  EXPECT_THROW(glue_layers(low, 0.02), NumericalFailure);
  Assembly slack = all_mobile();
  slack.cell.upper.z() += 0.01;
  EXPECT_THROW(glue_layers(slack, 1e-4), NumericalFailure);
}

}  // namespace
}  // namespace flowslide
