// SPDX-License-Identifier: GPL-2.0-or-later
#include "configuration/range.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace flowslide {
namespace {

TEST(Range, RespectsOpenAndClosedEnds) {
  EXPECT_FALSE(Range::positive().contains(0.0));
  EXPECT_TRUE(Range::positive().contains(1e-300));
  EXPECT_TRUE(Range::not_negative().contains(0.0));
  EXPECT_FALSE(Range::not_negative().contains(-1e-300));
  EXPECT_TRUE(Range::between(1.0, 2.0).contains(1.0));
  EXPECT_TRUE(Range::between(1.0, 2.0).contains(2.0));
  EXPECT_FALSE(Range::inside(1.0, 2.0).contains(1.0));
  EXPECT_FALSE(Range::inside(1.0, 2.0).contains(2.0));
  EXPECT_FALSE(Range::above_up_to(1.0, 2.0).contains(1.0));
  EXPECT_TRUE(Range::above_up_to(1.0, 2.0).contains(2.0));
  EXPECT_TRUE(Range::from_below(1.0, 2.0).contains(1.0));
  EXPECT_FALSE(Range::from_below(1.0, 2.0).contains(2.0));
  EXPECT_FALSE(Range::at_most(2.0).contains(2.5));
  EXPECT_FALSE(Range::below(2.0).contains(2.0));
}

TEST(Range, NeverContainsWhatIsNotFinite) {
  EXPECT_FALSE(Range::any().contains(std::numeric_limits<double>::quiet_NaN()));
  EXPECT_FALSE(Range::any().contains(std::numeric_limits<double>::infinity()));
  EXPECT_FALSE(Range::positive().contains(std::numeric_limits<double>::infinity()));
  EXPECT_TRUE(Range::any().contains(-1e300));
}

TEST(Range, SaysWhatItAllowsWithUnit) {
  EXPECT_EQ(Range::any().describe(dimension::stress), "any finite number");
  EXPECT_EQ(Range::positive().describe(dimension::stress), "above 0 Pa");
  EXPECT_EQ(Range::at_least(3).describe(), "at least 3");
  EXPECT_EQ(Range::at_most(3).describe(), "at most 3");
  EXPECT_EQ(Range::below(1e-5).describe(dimension::time), "below 1e-05 s");
  EXPECT_EQ(Range::between(0, 1).describe(), "between 0 and 1");
  EXPECT_EQ(Range::inside(0, 1).describe(), "above 0 and below 1");
  EXPECT_EQ(Range::above_up_to(0, 1).describe(), "above 0 and at most 1");
  EXPECT_EQ(Range::from_below(0, 1).describe(), "at least 0 and below 1");
}

}  // namespace
}  // namespace flowslide
