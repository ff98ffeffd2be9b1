// SPDX-License-Identifier: GPL-2.0-or-later
#include "input/read_profile_plan.hpp"

#include "configuration/error.hpp"
#include "support/messages.hpp"

namespace flowslide {
namespace {

TEST(ReadProfilePlan, TakesStrainsAndTheTableProfiles) {
  const auto configuration = Configuration::from_text(
      "[profiles]\nsublayers = 5\nsnapshots = 3\nwindow = 0.02\nread = \"first snapshot\"\n[point.a]\nprofile_strains "
      "= [0.01, 0.5]\n"
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

TEST(ReadProfilePlan, RefusesAProfileThatBeginsWithinTheOneBefore) {
  const auto text = [](const char* strains) {
    return std::string("[profiles]\nsublayers = 5\nsnapshots = 100\nwindow = 1\n[point.a]\nprofile_strains = ") +
           strains;
  };
  const auto plan = [&](const char* strains) {
    return read_profile_plan(Configuration::from_text(text(strains)), "point.a.profile_strains");
  };
  EXPECT_NEAR(plan("[0.1, 0.2]").last_strain(0), 0.199, 1e-12);
  EXPECT_CONTAINS(message_of<ConfigurationError>([&] { plan("[0.3, 0.4]"); }),
                  "has 0.4 before the last snapshot of the profile of 0.3, at 0.597; give strains that are farther "
                  "apart, or a smaller profiles.window");
}

}  // namespace
}  // namespace flowslide
