// SPDX-License-Identifier: GPL-2.0-or-later
#include "dem/liggghts/pair_histories.hpp"

#include <gtest/gtest.h>

#include "dem/liggghts/liggghts_engine.hpp"
#include "support/touching_lattice.hpp"

namespace flowslide {
namespace {

/// Three grains in a row along x, through the period: 0 touches 1, and 2 touches 0 across the border. The springs are
/// far below the Coulomb cap.
Assembly row() {
  Assembly assembly;
  assembly.cell.upper = {0.03, 0.03, 0.03};
  assembly.cell.periodic = {true, true, false};
  assembly.resize(3);
  assembly.radius = {3e-3, 3e-3, 3e-3};
  assembly.position = {{2.999e-3, 0.015, 0.015}, {8.99e-3, 0.015, 0.015}, {0.027, 0.015, 0.015}};
  assembly.contacts = {{0, 1, {0.0, 1e-9, 2e-9}, {0.0, 3e-9, 4e-9}}, {0, 2, {0.0, -5e-9, 6e-9}, {0.0, 7e-9, -8e-9}}};
  return assembly;
}

TEST(PairHistories, AreReadAsWrittenAlsoAcrossAPeriod) {
  LiggghtsEngine engine(testing::TempDir() + "histories.log");
  engine.load(row(), {});
  const auto contacts = engine.save().contacts;
  ASSERT_EQ(contacts.size(), 2u);
  for (std::size_t c = 0; c < 2; ++c) {
    EXPECT_EQ(contacts[c].first, row().contacts[c].first);
    EXPECT_EQ(contacts[c].second, row().contacts[c].second);
    EXPECT_EQ(contacts[c].tangential_spring, row().contacts[c].tangential_spring);
    EXPECT_EQ(contacts[c].rolling_torque, row().contacts[c].rolling_torque);
  }
}

TEST(PairHistories, ATouchingPairWithoutOneStartsUnloaded) {
  Assembly assembly = row();
  assembly.contacts.pop_back();
  LiggghtsEngine engine(testing::TempDir() + "histories.log");
  engine.load(assembly, {});
  const auto contacts = engine.save().contacts;
  ASSERT_EQ(contacts.size(), 2u);
  EXPECT_EQ(contacts[1].tangential_spring, Vector3::Zero());
  EXPECT_EQ(contacts[0].tangential_spring, row().contacts[0].tangential_spring);
}

TEST(PairHistories, SurviveARebuildOfTheNeighbourList) {
  Assembly assembly = row();
  assembly.velocity[2] = Vector3::Zero();
  LiggghtsEngine engine(testing::TempDir() + "histories.log");
  EngineSettings still;
  still.time_step = 1e-12;  // the springs hardly grow, and the list is rebuilt by `load`
  engine.load(assembly, still);
  engine.run(1);
  engine.load(engine.save(), still);
  engine.run(1);
  const auto contacts = engine.save().contacts;
  ASSERT_EQ(contacts.size(), 2u);
  EXPECT_LT((contacts[1].tangential_spring - row().contacts[1].tangential_spring).norm(), 1e-15);
}

}  // namespace
}  // namespace flowslide
