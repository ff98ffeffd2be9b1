// SPDX-License-Identifier: GPL-2.0-or-later
#include "app/plan.hpp"

#include <sstream>

#include "app/messages.hpp"

namespace flowslide {
namespace {

TEST(Plan, NumbersReplicatesFromTheSecondOn) {
  EXPECT_EQ(replicate_name("RD", 0), "RD");
  EXPECT_EQ(replicate_name("RD", 1), "RD_r2");
}

TEST(Plan, ExpectsLiggghtsToTakeLongerAndClosedFormsNoTime) {
  EXPECT_GT(seconds_per_grain_and_step("liggghts"), seconds_per_grain_and_step("native"));
  EXPECT_GT(seconds_per_grain_and_step("native-mixed"), 0.0);
  EXPECT_EQ(seconds_per_grain_and_step("elastic"), 0.0);
}

TEST(Plan, ShowsTheSearchForASample) {
  std::ostringstream out;
  print_sample_plan(out, {"loose", {}, {0.79, 0.002, 10}}, "native");
  EXPECT_CONTAINS(out.str(), "# sample loose: e0 = 0.79 +- 0.002, search from mu_1 = 0.3 and a drag of 0.03 kg/s");
  EXPECT_CONTAINS(out.str(), "# key of its first trial in the cache: ");
}

TEST(Plan, ShowsCommandsOfAnEngineThatTakesThem) {
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
