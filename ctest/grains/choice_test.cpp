// SPDX-License-Identifier: GPL-2.0-or-later
#include "grains/choice.hpp"

#include <gtest/gtest.h>

#include "grains/fields.hpp"
#include "support/messages.hpp"

namespace flowslide {

enum class Season { dry, wet };
template <>
struct ChoiceNames<Season> {
  static constexpr const char* what = "the season";
  static constexpr std::array names{"dry season", "wet season"};
};

namespace {

TEST(Choice, IsFoundByItsName) {
  for (const Season season : {Season::dry, Season::wet}) EXPECT_EQ(choice_of<Season>(name_of(season)), season);
  EXPECT_EQ(choice_names<Season>(), (std::vector<std::string>{"dry season", "wet season"}));
}

TEST(Choice, RefusesAnotherNameWithThoseAllowed) {
  EXPECT_EQ(message_of<std::invalid_argument>([] { choice_of<Season>("dry"); }),
            "the season \"dry\" is not known; choose one of: \"dry season\", \"wet season\"");
}

TEST(Choice, StandsInATextByItsName) { EXPECT_EQ(field_text(Season::wet), "wet season"); }

}  // namespace
}  // namespace flowslide
