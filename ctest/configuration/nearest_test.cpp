// SPDX-License-Identifier: GPL-2.0-or-later
#include "configuration/nearest.hpp"

#include <gtest/gtest.h>

namespace flowslide {
namespace {

TEST(EditDistance, CountsInsertionsDeletionsAndReplacements) {
  EXPECT_EQ(edit_distance("", ""), 0U);
  EXPECT_EQ(edit_distance("", "abc"), 3U);
  EXPECT_EQ(edit_distance("abc", ""), 3U);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
}

TEST(EditDistance, CountsASwapOfNeighboursOnce) { EXPECT_EQ(edit_distance("dnesity", "density"), 1U); }

TEST(EditDistance, IgnoresCase) { EXPECT_EQ(edit_distance("KPA", "kPa"), 0U); }

TEST(EditDistance, IsSymmetric) {
  EXPECT_EQ(edit_distance("liggghts", "ligghts"), edit_distance("ligghts", "liggghts"));
}

TEST(Nearest, FindsTheMisspelledKey) {
  EXPECT_EQ(nearest("sample.dnesity", {"sample.diameter", "sample.density", "slope.density"}), "sample.density");
}

TEST(Nearest, TakesTheFirstOfEquals) { EXPECT_EQ(nearest("ab", {"ax", "ay"}), "ax"); }

TEST(Nearest, DoesNotTakeWhatIsNotAlike) {
  EXPECT_EQ(nearest("huge", {"quick", "paper"}), "");
  EXPECT_EQ(nearest("foo", {"rate", "RD"}), "");
  EXPECT_EQ(nearest("carry", {"whole_increment", "carry_remainder"}), "carry_remainder");
}

TEST(Nearest, AsksForItOrSaysTheOther) {
  EXPECT_EQ(did_you_mean("ligghts", {"native", "liggghts"}, "choose one"), "did you mean \"liggghts\"?");
  EXPECT_EQ(did_you_mean("lammps", {"native", "liggghts"}, "choose one"), "choose one");
}

TEST(Nearest, IsEmptyWithoutCandidates) { EXPECT_EQ(nearest("density", {}), ""); }

TEST(ListOf, ReadsAsASentence) {
  EXPECT_EQ(list_of({}), "none");
  EXPECT_EQ(list_of({"a"}), "\"a\"");
  EXPECT_EQ(list_of({"a", "b"}), "\"a\" or \"b\"");
  EXPECT_EQ(list_of({"a", "b", "c"}), "\"a\", \"b\" or \"c\"");
}

}  // namespace
}  // namespace flowslide
