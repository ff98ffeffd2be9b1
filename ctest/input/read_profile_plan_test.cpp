// SPDX-License-Identifier: GPL-2.0-or-later
#include "input/read_profile_plan.hpp"

#include "configuration/error.hpp"
#include "support/messages.hpp"

namespace flowslide {
namespace {

TEST(ReadProfilePlan, TakesStrainsAndTheTableProfiles) {
  const auto configuration = Configuration::from_text(
      "[profiles]\nsublayers = 5\nsnapshots = 3\nwindow = 0.02\nread = \"first snapshot\"\n[point.a]\nprofile_strains = [0.01, 0.5]\n"
      "[point.b]\nprofile_strains = [0.5, 0.5]\n");
  const ProfilePlan plan = read_profile_plan(configuration, "point.a.profile_strains");
  EXPECT_EQ(plan.sublayers, 5);
  EXPECT_EQ(plan.snapshots, 3);
  EXPECT_EQ(plan.window, 0.02);
  EXPECT_EQ(plan.read, ProfileReading::first_snapshot);
  EXPECT_EQ(plan.strains, (std::vector{0.01, 0.5}));
  EXPECT_TRUE(read_profile_plan(configuration, "point.c.profile_strains").strains.empty());
  EXPECT_CONTAINS(message_of<ConfigurationError>([&] { read_profile_plan(configuration, "point.b.profile_strains"); }),
                  "does not increase; sort the strains and give each once");
}

}  // namespace
}  // namespace flowslide
