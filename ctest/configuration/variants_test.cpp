// SPDX-License-Identifier: GPL-2.0-or-later
// Copies of a configuration with one other value: Configuration::with_item and adopt.
#include "configuration/configuration.hpp"
#include "configuration/error.hpp"
#include "support/messages.hpp"

namespace flowslide::variants_test {
namespace {

constexpr const char* text = R"([slope]
angle = "5 deg"
thickness = "2 m"
[sweep]
angle = ["3 deg", "95 deg"]
single = 7
names = ["a", 1.5, true]
)";

TEST(Variants, TakeAnItemOfAListWithItsPlace) {
  const auto whole = Configuration::from_text(text, "mine.toml");
  const Configuration variant = whole.with_item("slope.angle", "sweep.angle", 0);
  EXPECT_DOUBLE_EQ(variant.quantity("slope.angle", dimension::angle), 3.0 * 0.017453292519943295);
  EXPECT_DOUBLE_EQ(whole.quantity("slope.angle", dimension::angle), 5.0 * 0.017453292519943295);
  const Configuration steep = whole.with_item("slope.angle", "sweep.angle", 1);
  EXPECT_CONTAINS(message_of<ConfigurationError>(
                      [&] { steep.quantity("slope.angle", dimension::angle, Range::between(0.0, 1.5)); }),
                  "mine.toml:5:19: slope.angle = \"95 deg\" is not allowed");
  EXPECT_EQ(whole.with_item("count", "sweep.single", 0).integer("count"), 7);
  EXPECT_THROW(whole.with_item("count", "sweep.single", 1), std::out_of_range);
  EXPECT_THROW(whole.with_item("count", "sweep.missing", 0), ConfigurationError);
}

TEST(Variants, AddTheTablesAboveAKey) {
  const auto whole = Configuration::from_text(text);
  const Configuration variant = whole.with_item("point.one.coupling.step", "sweep.single", 0);
  EXPECT_EQ(variant.subtables("point"), std::vector<std::string>{"one"});
  EXPECT_EQ(variant.integer("point.one.coupling.step"), 7);
  EXPECT_FALSE(variant.is_users_table("point.one"));
}

TEST(Variants, GiveTheirReadersToTheWhole) {
  const auto whole = Configuration::from_text(text);
  whole.integer("sweep.single");
  const Configuration variant = whole.with_item("slope.angle", "sweep.angle", 0);
  variant.quantity("slope.angle", dimension::angle);
  EXPECT_CONTAINS_NOT(variant.resolved(), "sweep.single");
  variant.quantity("slope.thickness", dimension::length);
  whole.adopt(variant);
  EXPECT_EQ(whole.resolved(), "slope.thickness = \"2.0 m\"\nsweep.single = 7\n");
  const std::string unknown = message_of<ConfigurationError>([&] { whole.reject_unknown(); });
  EXPECT_CONTAINS(unknown, "unknown key \"sweep.names\"");
  EXPECT_CONTAINS_NOT(unknown, "slope.angle");
}

TEST(Variants, TellKeysAndItems) {
  const auto whole = Configuration::from_text(text);
  EXPECT_EQ(whole.keys_below("sweep"), (std::vector<std::string>{"angle", "single", "names"}));
  EXPECT_EQ(whole.keys_below("nothing"), std::vector<std::string>{});
  EXPECT_CONTAINS(message_of<ConfigurationError>([&] { whole.keys_below("sweep.angle"); }), "but a table is needed");
  EXPECT_TRUE(whole.is_list("sweep.angle"));
  EXPECT_FALSE(whole.is_list("sweep.single"));
  EXPECT_EQ(whole.items_of("sweep.names"), (std::vector<std::string>{"a", "1.5", "true"}));
  EXPECT_EQ(whole.items_of("sweep.single"), std::vector<std::string>{"7"});
}

TEST(Variants, RefuseAValueThatNothingReads) {
  const auto whole = Configuration::from_text(text, "mine.toml");
  const Configuration variant = whole.with_item("slope.angle", "sweep.angle", 0);
  EXPECT_EQ(message_of<ConfigurationError>([&] { variant.require_effect("slope.angle"); }),
            "mine.toml:5:10: slope.angle = \"3 deg\" has no effect: no run reads it; sweep another key");
  variant.accept("slope.angle", "level ground does not use it");
  EXPECT_CONTAINS(message_of<ConfigurationError>([&] { variant.require_effect("slope.angle"); }), "no effect");
  variant.quantity("slope.angle", dimension::angle);
  EXPECT_NO_THROW(variant.require_effect("slope.angle"));
}

}  // namespace
}  // namespace flowslide::variants_test
