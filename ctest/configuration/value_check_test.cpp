// SPDX-License-Identifier: GPL-2.0-or-later
#include "configuration/value_check.hpp"

#include "configuration/error.hpp"
#include "support/messages.hpp"

namespace flowslide::value_check_test {
namespace {

Scalar scalar(ScalarValue value, std::string written) {
  return {std::move(value), {"case.toml", 3, 7}, std::move(written)};
}

template <typename Call>
std::string complaint(Call&& call) {
  return message_of<ConfigurationError>(std::forward<Call>(call));
}

TEST(CheckedQuantity, TakesTextsWithUnitsAndBareNumbersWithoutDimension) {
  EXPECT_EQ(checked_quantity("a", scalar(3.5, "3.5"), dimension::dimensionless, Range::any()), 3.5);
  EXPECT_EQ(checked_quantity("a", scalar(std::int64_t{3}, "3"), dimension::dimensionless, Range::any()), 3.0);
  EXPECT_EQ(checked_quantity("a", scalar(std::int64_t{0}, "0"), dimension::stress, Range::any()), 0.0);
  EXPECT_EQ(checked_quantity("a", scalar("3 kPa", "\"3 kPa\""), dimension::stress, Range::any()), 3000.0);
}

TEST(CheckedQuantity, RefusesABareNumberThatNeedsAUnit) {
  const Range allowed = Range::between(0.0, 1.5);
  EXPECT_EQ(
      complaint([&] { checked_quantity("slope.angle", scalar(std::int64_t{4}, "4"), dimension::angle, allowed); }),
      "case.toml:3:7: slope.angle = 4 has no unit: it would be 4 rad = 229.2 deg; write \"4 deg\" or \"4 rad\"");
  EXPECT_EQ(complaint([&] { checked_quantity("a", scalar(2.5, "2.5"), dimension::stress, Range::any()); }),
            "case.toml:3:7: a = 2.5 has no unit: it would be 2.5 Pa; write \"2.5 kPa\" or \"2.5 Pa\"");
  EXPECT_EQ(complaint([&] { checked_quantity("a", scalar("2", "\"2\""), dimension::stress, Range::any()); }),
            "case.toml:3:7: a: \"2\" has no unit: it would be 2 Pa; write \"2 kPa\" or \"2 Pa\"");
  const Scalar option{std::int64_t{2}, {"--set loading.amplitude=2", 0, 0}, "2"};
  EXPECT_EQ(complaint([&] { checked_quantity("loading.amplitude", option, dimension::stress, Range::any()); }),
            "--set loading.amplitude=2: the value has no unit: it would be 2 Pa; write \"2 kPa\" or \"2 Pa\"");
}

TEST(CheckedQuantity, SaysPlaceKeyValueAndRange) {
  EXPECT_EQ(complaint([] {
              checked_quantity("sample.stress", scalar("-3 kPa", "\"-3 kPa\""), dimension::stress, Range::positive());
            }),
            "case.toml:3:7: sample.stress = \"-3 kPa\" is not allowed: it must be above 0 Pa; change it there or give "
            "another with --set");
}

TEST(CheckedQuantity, RefusesInfinityWhateverTheRange) {
  EXPECT_EQ(complaint([] {
              checked_quantity("a", scalar(std::numeric_limits<double>::infinity(), "inf"), dimension::stress, {});
            }),
            "case.toml:3:7: a = inf is not allowed: it must be any finite number; change it there or give another with "
            "--set");
}

TEST(CheckedQuantity, SaysPlaceAndKeyWithAWrongDimension) {
  EXPECT_EQ(complaint([] { checked_quantity("a", scalar("3 m", "\"3 m\""), dimension::stress, Range::any()); }),
            "case.toml:3:7: a: \"3 m\" is a length, but a stress is expected, such as \"3 kPa\"");
}

TEST(CheckedQuantity, SaysWhatTypeIsWanted) {
  EXPECT_EQ(
      complaint([] { checked_quantity("a", scalar(true, "true"), dimension::stress, Range::positive()); }),
      "case.toml:3:7: a = true is true or false, but a stress, above 0 Pa is needed; write, for example, \"3 kPa\"");
}

TEST(CheckedInteger, TakesWholeNumbersOnly) {
  EXPECT_EQ(checked_integer("a", scalar(1e6, "1e6"), Range::any()), 1'000'000);
  EXPECT_EQ(checked_integer("a", scalar(std::int64_t{9007199254740993}, "9007199254740993"), Range::any()),
            9007199254740993);
  EXPECT_EQ(complaint([] { checked_integer("a", scalar(2.5, "2.5"), Range::any()); }),
            "case.toml:3:7: a = 2.5 is not an integer; write a number without fraction");
  EXPECT_EQ(complaint([] { checked_integer("a", scalar(1e300, "1e300"), Range::any()); }),
            "case.toml:3:7: a = 1e300 is not an integer; write a number without fraction");
  EXPECT_EQ(complaint([] { checked_integer("a", scalar("20", "\"20\""), Range::any()); }),
            "case.toml:3:7: a = \"20\" is text, but an integer is needed; write, for example, 20");
  EXPECT_EQ(
      complaint([] { checked_integer("layers", scalar(std::int64_t{2}, "2"), Range::at_least(3)); }),
      "case.toml:3:7: layers = 2 is not allowed: it must be at least 3; change it there or give another with --set");
}

TEST(CheckedText, ProposesTheNearestOfWhatIsAllowed) {
  EXPECT_EQ(checked_text("engine", scalar("native", "'native'"), {"liggghts", "native"}), "native");
  EXPECT_EQ(checked_text("title", scalar("any", "'any'"), {}), "any");
  EXPECT_EQ(complaint([] {
              checked_text("engine", scalar("ligghts", "'ligghts'"), {"native", "liggghts"});
            }),
            "case.toml:3:7: engine = 'ligghts' is not allowed: it must be \"native\" or \"liggghts\"; did you mean "
            "\"liggghts\"?");
  EXPECT_EQ(complaint([] { checked_text("engine", scalar(1.0, "1.0"), {"native"}); }),
            "case.toml:3:7: engine = 1.0 is a number, but text is needed; write, for example, \"native\"");
}

TEST(CheckedFlag, TakesTrueAndFalseOnly) {
  EXPECT_TRUE(checked_flag("a", scalar(true, "true")));
  EXPECT_EQ(complaint([] { checked_flag("a", scalar(std::int64_t{1}, "1")); }),
            "case.toml:3:7: a = 1 is an integer, but true or false is needed; write, for example, true");
}

TEST(RefuseValue, DoesNotRepeatAnOption) {
  const Scalar given{std::int64_t{2}, {"--set layers=2", 0, 0}, "2"};
  EXPECT_EQ(complaint([&] { refuse_value("layers", given, "is too few", "use 3"); }),
            "--set layers=2: the value is too few; use 3");
}

}  // namespace
}  // namespace flowslide::value_check_test
