// SPDX-License-Identifier: GPL-2.0-or-later
#include "grains/fields.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "support/perturb.hpp"

namespace flowslide {
namespace {

enum class Colour { red, green };

struct Inner {
  double length = 0.1;
  std::int64_t count = 3;
  static constexpr auto fields() {
    return std::tuple{Field{"length", &Inner::length, "m", Bounds::positive()},
                      Field{"count", &Inner::count, "1", Bounds::between(1, 5)}};
  }
};

struct Outer {
  Inner inner;
  std::array<double, 3> rates{1.0, 2.0, 3.0};
  bool on = false;
  Colour colour = Colour::red;
  int most = 7;
  std::uint64_t seed = 1;
  static constexpr auto fields() {
    return std::tuple{Field{"inner", &Outer::inner},
                      Field{"rates", &Outer::rates, "1/s", Bounds::not_negative()},
                      Field{"on", &Outer::on},
                      Field{"colour", &Outer::colour},
                      Field{"most", &Outer::most, "1", Bounds::any(), Effect::limit_only},
                      Field{"seed", &Outer::seed}};
  }
};

struct LeavesOneOut {
  double first = 1.0, second = 2.0;
  static constexpr auto fields() { return std::tuple{Field{"first", &LeavesOneOut::first}}; }
};

struct NamesOneTwice {
  double first = 1.0, second = 2.0;
  static constexpr auto fields() {
    return std::tuple{Field{"first", &NamesOneTwice::first}, Field{"second", &NamesOneTwice::first}};
  }
};

TEST(Fields, AListThatLeavesOutAMemberIsToldAtCompileTime) {
  static_assert(lists_every_member<Inner>());
  static_assert(lists_every_member<Outer>());
  static_assert(!lists_every_member<LeavesOneOut>());
  static_assert(!lists_every_member<NamesOneTwice>());
}

TEST(Fields, TextHasALineForEachFieldWithAnEffectOnTheResult) {
  EXPECT_EQ(text_of_fields(Outer{}),
            "inner.length = 0.1\ninner.count = 3\nrates = 1 2 3\non = false\ncolour = 0\nseed = 1\n");
}

TEST(Fields, TheSmallestChangeOfAnyFieldMakesAnotherText) {
  int changes = 0;
  for_each_perturbation(Outer{}, [&](const std::string& name, const auto& field, const Outer& changed) {
    ++changes;
    EXPECT_EQ(text_of_fields(changed) == text_of_fields(Outer{}), field.effect == Effect::limit_only) << name;
  });
  EXPECT_EQ(changes, 9);
}

TEST(Fields, ValidationVisitsEachNumberWithItsBounds) {
  EXPECT_NO_THROW(validate_fields(Outer{}));
  Outer outer;
  outer.rates[2] = -1.0;
  EXPECT_THROW(validate_fields(outer), std::invalid_argument);
  outer = {};
  outer.inner.count = 6;
  try {
    validate_fields(outer);
    ADD_FAILURE() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "inner.count = 6 is not allowed: it must be at least 1 and at most 5; change it");
  }
}

TEST(Bounds, ContainTheirEndsOnlyWhereAllowedAndNothingThatIsNotFinite) {
  EXPECT_TRUE(Bounds::between(0, 1).contain(0.0));
  EXPECT_TRUE(Bounds::between(0, 1).contain(1.0));
  EXPECT_FALSE(Bounds::inside(0, 1).contain(0.0));
  EXPECT_FALSE(Bounds::inside(0, 1).contain(1.0));
  EXPECT_TRUE(Bounds::from_below(0, 1).contain(0.0));
  EXPECT_FALSE(Bounds::from_below(0, 1).contain(1.0));
  EXPECT_FALSE(Bounds::above_up_to(0, 1).contain(0.0));
  EXPECT_TRUE(Bounds::above_up_to(0, 1).contain(1.0));
  EXPECT_FALSE(Bounds::positive().contain(0.0));
  EXPECT_TRUE(Bounds::not_negative().contain(0.0));
  EXPECT_FALSE(Bounds::any().contain(std::nan("")));
  EXPECT_FALSE(Bounds::any().contain(HUGE_VAL));
}

TEST(Bounds, Describe) {
  EXPECT_EQ(Bounds::any().describe(), "any finite number");
  EXPECT_EQ(Bounds::positive().describe(), "above 0");
  EXPECT_EQ(Bounds::from_below(0, 0.5).describe(), "at least 0 and below 0.5");
}

}  // namespace
}  // namespace flowslide
