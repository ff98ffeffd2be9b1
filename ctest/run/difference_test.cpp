// SPDX-License-Identifier: GPL-2.0-or-later
#include "run/difference.hpp"

#include <gtest/gtest.h>

namespace flowslide {
namespace {

TEST(Difference, NamesWhatChanged) {
  const char* there = "count = 3\nengine = \"native\"\nsize = \"0.002 m\"\n";
  EXPECT_EQ(difference_of(there, there), "");
  EXPECT_EQ(difference_of(there, "count = 4\nengine = \"native\"\nsize = \"0.003 m\"\n"),
            "count = 3 there, 4 now; size = \"0.002 m\" there, \"0.003 m\" now");
  EXPECT_EQ(difference_of(there, "engine = \"native\"\nsize = \"0.002 m\"\nwidth = 1\n"),
            "count = 3 is only there; width = 1 is new");
}

TEST(Difference, StopsAfterSome) {
  EXPECT_EQ(difference_of("a = 1\nb = 1\nc = 1\n", "a = 2\nb = 2\nc = 2\n", 1), "a = 1 there, 2 now; and 2 more");
}

TEST(Difference, BearsAnyText) {
  EXPECT_EQ(difference_of("", ""), "");
  EXPECT_EQ(difference_of("no equals\n\n", "a = \n"), "a =  is new");
}

}  // namespace
}  // namespace flowslide
