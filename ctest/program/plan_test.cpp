// SPDX-License-Identifier: GPL-2.0-or-later
#include "program/plan.hpp"

#include <sstream>

#include "support/messages.hpp"

namespace flowslide {
namespace {

TEST(Plan, NumbersReplicatesFromTheSecondOn) {
  EXPECT_EQ(replicate_name("RD", 0), "RD");
  EXPECT_EQ(replicate_name("RD", 1), "RD_r2");
}

TEST(Plan, ExpectsLiggghtsToTakeLongerAndClosedFormsNoTime) {
  EXPECT_GT(seconds_per_grain_and_step("liggghts"), seconds_per_grain_and_step("native"));
  EXPECT_GT(seconds_per_grain_and_step("native"), seconds_per_grain_and_step("native-mixed"));
  EXPECT_GT(seconds_per_grain_and_step("native-mixed"), 0.0);
  EXPECT_EQ(seconds_per_grain_and_step("elastic"), 0.0);
}

TEST(Plan, ShowsTheSearchForASample) {
  std::ostringstream out;
  print_sample_plan(out, {"loose", {}, {0.79, 0.002, 10}}, "native");
  EXPECT_CONTAINS(out.str(), "# sample loose: e0 = 0.79 +- 0.002, search from mu_1 = 0.3 and a drag of 0.03 kg/s");
  EXPECT_CONTAINS(out.str(), "# key of its first trial in the cache: ");
}

TEST(Plan, ShowsTheSampleThatWasFoundWithItsHealth) {
  FoundSample found;
  found.sample.void_ratio = 0.7823;
  std::ostringstream lattice, mixed;
  print_found_sample(lattice, {"loose", {}, {}}, found);
  EXPECT_EQ(lattice.str().rfind("sample loose, seed 1, mu_1 0.3, drag 0.03 kg/s, lattice: e0 0.7823 (probe 0", 0), 0u)
      << lattice.str();
  EXPECT_EQ(lattice.str().find("uneven"), std::string::npos);
  found.recipe.mixing_velocity = 0.5;
  found.health.axes[1].middle_order = {0.4, 600};
  print_found_sample(mixed, {"loose", {}, {}}, found);
  EXPECT_CONTAINS(mixed.str(), "mixed at 0.5 m/s: ");
  EXPECT_CONTAINS(mixed.str(), "order of the lattice along y: in the middle of the cell it is 0.4, where 0.112");
}

TEST(Plan, ShowsCommandsOfLiggghtsWhichTakesThem) {
  std::ostringstream liggghts, native;
  SampleRecipe recipe;
  recipe.packing.counts = {5, 5, 6};
  print_engine_plan(liggghts, recipe, "liggghts", 1e-5);
  print_engine_plan(native, recipe, "native", 1e-5);
  EXPECT_CONTAINS(liggghts.str(), "pair_style");
  EXPECT_EQ(native.str(), "");
}

}  // namespace
}  // namespace flowslide
