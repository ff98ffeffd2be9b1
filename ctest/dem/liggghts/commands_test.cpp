// SPDX-License-Identifier: GPL-2.0-or-later
#include "dem/liggghts/commands.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "support/touching_lattice.hpp"

namespace flowslide {
namespace {

std::string command_that_starts(const std::vector<std::string>& commands, const std::string& start) {
  const auto found = std::find_if(commands.begin(), commands.end(),
                                  [&](const std::string& line) { return line.starts_with(start); });
  return found == commands.end() ? "" : *found;
}

TEST(Commands, AllowHardParticlesBeforeAnythingElse) {
  EXPECT_EQ(setup_commands(touching_lattice(), {}).front(), "hard_particles yes");
}

TEST(Commands, ClearHistoriesOfPairsThatSeparate) {
  const std::string line = command_that_starts(setup_commands(touching_lattice(), {}), "neigh_modify");
  EXPECT_NE(line.find("contact_distance_factor 1.005"), std::string::npos) << line;
  const std::string stock =
      command_that_starts(setup_commands(touching_lattice(), {}, SeparatedHistory::kept), "neigh_modify");
  EXPECT_EQ(stock.substr(stock.size() - 2), " 1") << stock;
}

TEST(Commands, KeepEveryDigitOfTheSettings) {
  EngineSettings settings;
  settings.time_step = 1.0 / 3.0 * 1e-6;
  settings.material.restitution = 0.1 + 0.2;
  const auto commands = setup_commands(touching_lattice(), settings);
  std::istringstream step(command_that_starts(commands, "timestep").substr(9));
  double value = 0.0;
  step >> value;
  EXPECT_EQ(value, settings.time_step);
  std::istringstream restitution(command_that_starts(commands, "fix coefficientRestitution"));
  std::string word;
  for (int skip = 0; skip < 7; ++skip) restitution >> word;  // up to the number of types
  for (int pair = 0; pair < 9; ++pair) {
    ASSERT_TRUE(restitution >> value);
    EXPECT_EQ(value, settings.material.restitution);
  }
}

TEST(Commands, NameTheSwitchesOfTheLaw) {
  EngineSettings settings;
  const auto style = [&] { return command_that_starts(setup_commands(touching_lattice(), settings), "pair_style"); };
  const std::string models = "pair_style gran model hertz tangential history rolling_friction epsd3 ";
  EXPECT_EQ(style(), models + "limitForce off torsionTorque off");
  settings.material.torsion_resistance = true;
  EXPECT_EQ(style(), models + "limitForce off torsionTorque on");
  settings.material.normal_force_limited = true;
  EXPECT_EQ(style(), models + "limitForce on torsionTorque on");
}

TEST(Commands, LeaveRoomBeyondPlanesAndNoneBeyondPeriods) {
  Assembly assembly = touching_lattice();
  assembly.cell.lower = {0.0, 0.0, 0.0};
  assembly.cell.upper = {1.0, 2.0, 4.0};
  const auto commands = setup_commands(assembly, {});
  EXPECT_EQ(command_that_starts(commands, "region"), "region box block 0 1 0 2 -1 5 units box");
  EXPECT_EQ(command_that_starts(commands, "boundary"), "boundary p p f");
}

TEST(Commands, IntegrateMobileGrainsAloneAndLeaveOutPairsOfALayer) {
  const auto commands = grain_commands();
  EXPECT_NE(command_that_starts(commands, "group mobile type 1"), "");
  EXPECT_NE(command_that_starts(commands, "fix integrate mobile nve/sphere"), "");
  EXPECT_NE(command_that_starts(commands, "neigh_modify exclude type 2 2"), "");
  EXPECT_NE(command_that_starts(commands, "neigh_modify exclude type 3 3"), "");
}

TEST(Commands, TypesAndRolesAreOneToOne) {
  for (const Role role : {Role::mobile, Role::bottom_layer, Role::top_layer}) EXPECT_EQ(role_of(atom_type(role)), role);
}

}  // namespace
}  // namespace flowslide
