// SPDX-License-Identifier: GPL-2.0-or-later
#include "grains/require.hpp"

#include <gtest/gtest.h>

#include "support/comma_locale.hpp"

namespace flowslide {
namespace {

TEST(Require, IsSilentWhenAllowed) { EXPECT_NO_THROW(require(true, "size", 1.0, "> 0", "Grow.")); }

TEST(Require, SaysWhatIsWrongTheValueWhatIsAllowedAndHowToMend) {
  try {
    require(false, "size", -0.5, "> 0", "Grow.");
    FAIL() << "nothing thrown";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "size is -0.5; allowed: > 0. Grow.");
  }
}

TEST(Require, WritesNumbersWithAPointInEveryLocale) {
  const CommaLocale host;
  try {
    require(false, "size", 1234567.5, "> 0", "Grow.");
    FAIL() << "nothing thrown";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "size is 1234567.5; allowed: > 0. Grow.");
  }
}

}  // namespace
}  // namespace flowslide
