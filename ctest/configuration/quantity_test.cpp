// SPDX-License-Identifier: GPL-2.0-or-later
#include "configuration/quantity.hpp"

#include <numbers>
#include <stdexcept>

#include "support/messages.hpp"

namespace flowslide::quantity_test {
namespace {

std::string complaint(const std::string& text, const Dimension& expected) {
  return message_of<std::invalid_argument>([&] { parse_quantity(text, expected); });
}

struct Case {
  const char* text;
  Dimension dimension;
  double value;
};

/// For the names of the tests, which would show addresses otherwise, and change with each run.
void PrintTo(const Case& tested, std::ostream* out) { *out << tested.text; }

class EachQuantity : public testing::TestWithParam<Case> {};

TEST_P(EachQuantity, IsReadExactly) {
  EXPECT_EQ(parse_quantity(GetParam().text, GetParam().dimension), GetParam().value);
}

INSTANTIATE_TEST_SUITE_P(
    Quantity, EachQuantity,
    testing::Values(
        Case{"3 kPa", dimension::stress, 3000.0}, Case{"3kPa", dimension::stress, 3000.0},
        Case{"  28.34  kPa ", dimension::stress, 28340.0}, Case{"2 GPa", dimension::stress, 2.0e9},
        Case{"5e-7 s", dimension::time, 5e-7}, Case{"0.5 us", dimension::time, 5e-7},
        Case{"0.2 m", dimension::length, 0.2}, Case{"7.5 mm", dimension::length, 0.0075},
        Case{"0.3 mm", dimension::length, 0.0003}, Case{"2650 kg/m^3", dimension::density, 2650.0},
        Case{"2.65 t/m^3", dimension::density, 2650.0}, Case{"2650 kg m^-3", dimension::density, 2650.0},
        Case{"2.65 g/cm^3", dimension::density, 2650.0}, Case{"9.81 kN/m^3", dimension::unit_weight, 9810.0},
        Case{"9.81 m/s/s", dimension::acceleration, 9.81}, Case{"9.81 m/s^2", dimension::acceleration, 9.81},
        Case{"1e3 kPa/min", dimension::stress_rate, 1e6 / 60.0}, Case{"0.03 kg/s", dimension::mass_rate, 0.03},
        Case{"4e-5 m/s", dimension::velocity, 4e-5}, Case{"36 km/h", dimension::velocity, 10.0},
        Case{"0.06 1/s", dimension::rate, 0.06}, Case{"0.06/s", dimension::rate, 0.06},
        Case{"25 %", dimension::dimensionless, 0.25}, Case{"3 %/s", dimension::rate, 0.03},
        Case{"5 deg", dimension::angle, 5.0 * std::numbers::pi / 180.0}, Case{"10 N", dimension::force, 10.0},
        Case{"10 kg*m/s^2", dimension::force, 10.0}, Case{"1e-3 Pa s", dimension::viscosity, 1e-3},
        Case{"-4 kPa", dimension::stress, -4000.0}, Case{"+4 kPa", dimension::stress, 4000.0},
        Case{"2 s^-1", dimension::rate, 2.0}, Case{"1 d", dimension::time, 86400.0},
        Case{"864 mm/day", dimension::velocity, 1e-5}));

TEST(Quantity, SaysWhetherThereIsAUnit) {
  EXPECT_FALSE(parse_quantity("28340").has_unit);
  EXPECT_TRUE(parse_quantity("25 %").has_unit);
}

TEST(Quantity, RefusesABareNumberWithTheReadingsThatItCouldHave) {
  EXPECT_EQ(complaint("4", dimension::angle),
            "\"4\" has no unit: it would be 4 rad = 229.2 deg; write \"4 deg\" or \"4 rad\"");
  EXPECT_EQ(complaint(" 2 ", dimension::stress), "\" 2 \" has no unit: it would be 2 Pa; write \"2 kPa\" or \"2 Pa\"");
  EXPECT_EQ(complaint("5e-7", dimension::time), "\"5e-7\" has no unit: it would be 5e-7 s; write \"5e-7 s\"");
  EXPECT_EQ(message_of<std::invalid_argument>([] { parse_quantity("24", dimension::time, "h"); }),
            "\"24\" has no unit: it would be 24 s; write \"24 h\" or \"24 s\"");
  EXPECT_CONTAINS(complaint("2", {1, -2, 0, 0}), "it would be 2 kg m^-2; write \"2 kg m^-2\"");
}

TEST(Quantity, TakesABareZeroAndBareNumbersWhereThereIsNoUnit) {
  EXPECT_EQ(parse_quantity("0", dimension::stress), 0.0);
  EXPECT_EQ(parse_quantity("-0.0", dimension::angle), 0.0);
  EXPECT_EQ(parse_quantity("0.25", dimension::dimensionless), 0.25);
}

TEST(Quantity, NamesTextExpectedAndGivenWhenTheDimensionIsWrong) {
  EXPECT_EQ(complaint("3 m", dimension::stress), "\"3 m\" is a length, but a stress is expected, such as \"3 kPa\"");
  EXPECT_EQ(complaint("3 m", dimension::dimensionless),
            "\"3 m\" is a length, but a number without unit is expected, such as \"0.25\"");
  EXPECT_CONTAINS(complaint("3 kg^2", dimension::stress), "is a quantity in kg^2, but a stress");
}

TEST(Quantity, KeepsAnglesApartFromRatios) {
  EXPECT_CONTAINS(complaint("5 deg", dimension::dimensionless), "is an angle");
  EXPECT_CONTAINS(complaint("5 %", dimension::angle), "an angle is expected, such as \"5 deg\"");
}

TEST(Quantity, ProposesTheNearestUnit) {
  EXPECT_CONTAINS(complaint("3 kpa", dimension::stress), "unknown unit \"kpa\"; did you mean \"kPa\"?");
  EXPECT_CONTAINS(complaint("3 sec", dimension::time), "unknown unit \"sec\"; did you mean \"s\"?");
  EXPECT_CONTAINS(complaint("3 hours", dimension::time), "did you mean \"h\"?");
  EXPECT_CONTAINS(complaint("5 \u00B0", dimension::angle), "unknown unit \"\u00B0\"; did you mean \"deg\"?");
  EXPECT_CONTAINS(complaint("5 \u00B5m", dimension::length), "did you mean \"um\"?");
}

TEST(Quantity, RefusesWhatIsNoQuantity) {
  EXPECT_CONTAINS(complaint("", dimension::stress), "does not begin with a number");
  EXPECT_CONTAINS(complaint("kPa", dimension::stress), "does not begin with a number; write, for example, \"3 kPa\"");
  EXPECT_CONTAINS(complaint("high", dimension::dimensionless), "write, for example, \"0.25\"");
  EXPECT_CONTAINS(complaint("+-3 kPa", dimension::stress), "does not begin with a number");
  EXPECT_CONTAINS(complaint("nan Pa", dimension::stress), "not a finite number");
  EXPECT_CONTAINS(complaint("inf Pa", dimension::stress), "not a finite number");
  EXPECT_CONTAINS(complaint("1e999 Pa", dimension::stress), "too large");
  EXPECT_CONTAINS(complaint("1e308 kPa", dimension::stress), "too large");
  EXPECT_CONTAINS(complaint("3 kPa/", dimension::stress), "ends with \"*\" or \"/\"; a unit must follow");
  EXPECT_CONTAINS(complaint("3 kg//m", dimension::stress), "two signs");
  EXPECT_CONTAINS(complaint("3 m^", dimension::length), "after \"^\"");
  EXPECT_CONTAINS(complaint("3 m^0", dimension::length), "after \"^\"");
  EXPECT_CONTAINS(complaint("3 m^99999999999", dimension::length), "after \"^\"");
  EXPECT_CONTAINS(complaint("3 1 kPa", dimension::stress), "\"1 kPa\" in place of a unit");
  EXPECT_CONTAINS(complaint("3,5 kPa", dimension::stress), "\",5 kPa\" in place of a unit");
  EXPECT_CONTAINS(complaint("3 kPa; rm", dimension::stress), "in place of a unit");
}

TEST(Dimension, HasNameUnitAndExampleThatFitsItself) {
  for (const Dimension& dimension : {dimension::dimensionless, dimension::angle,        dimension::mass,
                                     dimension::length,        dimension::time,         dimension::rate,
                                     dimension::velocity,      dimension::acceleration, dimension::area,
                                     dimension::volume,        dimension::density,      dimension::unit_weight,
                                     dimension::force,         dimension::stress,       dimension::stress_rate,
                                     dimension::viscosity,     dimension::mass_rate,    dimension::compressibility,
                                     dimension::energy,        Dimension{1, -2, 0, 0}}) {
    EXPECT_NO_THROW(parse_quantity(example_of(dimension), dimension)) << name_of(dimension);
    EXPECT_EQ(parse_quantity("2 " + unit_of(dimension), dimension), 2.0) << name_of(dimension);
  }
  EXPECT_EQ(unit_of({1, -2, 0, 0}), "kg m^-2");
}

}  // namespace
}  // namespace flowslide::quantity_test
