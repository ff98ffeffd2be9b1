// SPDX-License-Identifier: GPL-2.0-or-later
#include "configuration/quantity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "configuration/nearest.hpp"

namespace flowslide {
namespace {

struct Unit {
  std::string_view symbol;
  Dimension dimension;
  double numerator = 1.0;    // one unit is numerator/denominator in SI units; both are exact numbers (except pi),
  double denominator = 1.0;  // so a conversion rounds once for the product and once for the quotient
};

constexpr std::array units{
    Unit{"kg", dimension::mass},
    Unit{"g", dimension::mass, 1.0, 1e3},
    Unit{"t", dimension::mass, 1e3},
    Unit{"m", dimension::length},
    Unit{"cm", dimension::length, 1.0, 1e2},
    Unit{"mm", dimension::length, 1.0, 1e3},
    Unit{"um", dimension::length, 1.0, 1e6},
    Unit{"km", dimension::length, 1e3},
    Unit{"s", dimension::time},
    Unit{"ms", dimension::time, 1.0, 1e3},
    Unit{"us", dimension::time, 1.0, 1e6},
    Unit{"ns", dimension::time, 1.0, 1e9},
    Unit{"min", dimension::time, 60.0},
    Unit{"h", dimension::time, 3600.0},
    Unit{"d", dimension::time, 86400.0},
    Unit{"day", dimension::time, 86400.0},
    Unit{"Pa", dimension::stress},
    Unit{"kPa", dimension::stress, 1e3},
    Unit{"MPa", dimension::stress, 1e6},
    Unit{"GPa", dimension::stress, 1e9},
    Unit{"N", dimension::force},
    Unit{"mN", dimension::force, 1.0, 1e3},
    Unit{"kN", dimension::force, 1e3},
    Unit{"J", dimension::energy},
    Unit{"Hz", dimension::rate},
    Unit{"rad", dimension::angle},
    Unit{"deg", dimension::angle, std::numbers::pi, 180.0},
    Unit{"%", dimension::dimensionless, 1.0, 1e2},
};

/// Spellings that are refused, and the symbol that the message proposes.
struct Alias {
  std::string_view spelling;
  std::string_view symbol;
};

constexpr std::array aliases{
    Alias{"sec", "s"},       Alias{"second", "s"},   Alias{"seconds", "s"},   Alias{"minute", "min"},
    Alias{"minutes", "min"}, Alias{"hr", "h"},       Alias{"hour", "h"},      Alias{"hours", "h"},
    Alias{"days", "day"},    Alias{"degree", "deg"}, Alias{"degrees", "deg"}, Alias{"\u00B0", "deg"},
    Alias{"\u00B5m", "um"},  Alias{"\u03BCm", "um"}, Alias{"\u00B5s", "us"},  Alias{"\u03BCs", "us"},
    Alias{"percent", "%"},   Alias{"meter", "m"},    Alias{"metre", "m"},     Alias{"pascal", "Pa"},
    Alias{"newton", "N"},    Alias{"gram", "g"},     Alias{"ton", "t"},       Alias{"tonne", "t"},
};

struct Named {
  Dimension dimension;
  std::string_view name;
  std::string_view unit;  // SI
  std::string_view example;
  std::string_view usual{};  // the unit that users probably mean if they write none; empty: the SI unit
};

constexpr std::array named{
    Named{dimension::dimensionless, "a number without unit", "", "0.25"},
    Named{dimension::angle, "an angle", "rad", "5 deg", "deg"},
    Named{dimension::mass, "a mass", "kg", "0.2 kg"},
    Named{dimension::length, "a length", "m", "5 mm", "mm"},
    Named{dimension::time, "a time", "s", "5e-7 s"},
    Named{dimension::rate, "a rate", "1/s", "0.06 1/s"},
    Named{dimension::velocity, "a velocity", "m/s", "4e-5 m/s"},
    Named{dimension::acceleration, "an acceleration", "m/s^2", "9.81 m/s^2"},
    Named{dimension::area, "an area", "m^2", "0.04 m^2"},
    Named{dimension::volume, "a volume", "m^3", "0.001 m^3"},
    Named{dimension::density, "a density", "kg/m^3", "2650 kg/m^3"},
    Named{dimension::unit_weight, "a unit weight", "N/m^3", "9.81 kN/m^3", "kN/m^3"},
    Named{dimension::force, "a force", "N", "10 N"},
    Named{dimension::stress, "a stress", "Pa", "3 kPa", "kPa"},
    Named{dimension::stress_rate, "a stress rate", "Pa/s", "1e3 kPa/min", "kPa/s"},
    Named{dimension::viscosity, "a viscosity", "Pa s", "1e-3 Pa s"},
    Named{dimension::mass_rate, "a mass rate", "kg/s", "0.03 kg/s"},
    Named{dimension::compressibility, "a compressibility", "1/Pa", "2e-7 1/Pa"},
    Named{dimension::energy, "an energy", "J", "1e-3 J"},
};

const Named* find_named(const Dimension& dimension) {
  for (const Named& candidate : named)
    if (candidate.dimension == dimension) return &candidate;
  return nullptr;
}

[[noreturn]] void fail(std::string_view text, const std::string& problem) {
  throw std::invalid_argument(fmt::format("\"{}\" {}", text, problem));
}

const Unit& unit_named(std::string_view symbol, std::string_view text) {
  std::vector<std::string> symbols;
  for (const Unit& unit : units) {
    if (unit.symbol == symbol) return unit;
    symbols.emplace_back(unit.symbol);
  }
  const auto alias = std::find_if(aliases.begin(), aliases.end(), [&](const Alias& a) { return a.spelling == symbol; });
  const std::string proposed = alias != aliases.end() ? fmt::format("did you mean \"{}\"?", alias->symbol)
                                                      : did_you_mean(symbol, symbols, "choose another.");
  fail(text, fmt::format("has an unknown unit \"{}\"; {} Known units: {}", symbol, proposed, fmt::join(symbols, " ")));
}

/// Reads the product of units after a number.
class UnitReader {
 public:
  UnitReader(std::string_view text, std::string_view rest) : text_(text), rest_(rest) {}

  /// Multiplies `quantity` by the units: converts its value to SI units and adds their exponents to its dimension.
  void read(Quantity& quantity) {
    bool divide = false;
    bool operand_due = false;
    for (skip_blanks(); !rest_.empty(); skip_blanks()) {
      if (rest_.front() == '*' || rest_.front() == '/') {
        if (operand_due) fail(text_, "has two signs in its unit without a symbol between them");
        divide = rest_.front() == '/';
        operand_due = true;
        rest_.remove_prefix(1);
        continue;
      }
      read_factor(quantity, divide);
      divide = operand_due = false;
    }
    if (operand_due) fail(text_, "ends with \"*\" or \"/\"; a unit must follow");
    quantity.value = quantity.value * numerator_ / denominator_;
  }

 private:
  /// Includes bytes beyond ASCII. No unit has one, but the message about an unknown unit then shows the whole symbol.
  static bool is_symbol(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '%' || static_cast<unsigned char>(c) >= 0x80;
  }

  void skip_blanks() {
    while (!rest_.empty() && (rest_.front() == ' ' || rest_.front() == '\t')) rest_.remove_prefix(1);
  }

  void read_factor(Quantity& quantity, bool divide) {
    if (rest_.starts_with("1/")) {
      rest_.remove_prefix(1);  // the 1 of "1/s"
      return;
    }
    std::size_t length = 0;
    while (length < rest_.size() && is_symbol(rest_[length])) ++length;
    if (length == 0) fail(text_, fmt::format("has \"{}\" in place of a unit; write, for example, \"3 kPa\"", rest_));
    const Unit& unit = unit_named(rest_.substr(0, length), text_);
    rest_.remove_prefix(length);
    const int exponent = divide ? -read_exponent() : read_exponent();
    quantity.has_unit = true;
    quantity.dimension.kilogram += exponent * unit.dimension.kilogram;
    quantity.dimension.metre += exponent * unit.dimension.metre;
    quantity.dimension.second += exponent * unit.dimension.second;
    quantity.dimension.radian += exponent * unit.dimension.radian;
    for (int i = 0; i < std::abs(exponent); ++i) {
      numerator_ *= exponent > 0 ? unit.numerator : unit.denominator;
      denominator_ *= exponent > 0 ? unit.denominator : unit.numerator;
    }
  }

  int read_exponent() {
    if (rest_.empty() || rest_.front() != '^') return 1;
    int exponent = 0;
    const auto [end, error] = std::from_chars(rest_.data() + 1, rest_.data() + rest_.size(), exponent);
    if (error != std::errc{} || exponent == 0 || std::abs(exponent) > 9)
      fail(text_, "needs an integer from -9 to 9, except 0, after \"^\"; write, for example, \"2650 kg/m^3\"");
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    return exponent;
  }

  std::string_view text_;
  std::string_view rest_;
  double numerator_ = 1.0;
  double denominator_ = 1.0;
};

}  // namespace

std::string name_of(const Dimension& dimension) {
  if (const Named* found = find_named(dimension)) return std::string(found->name);
  return "a quantity in " + unit_of(dimension);
}

std::string unit_of(const Dimension& dimension) {
  if (const Named* found = find_named(dimension)) return std::string(found->unit);
  std::string text;
  const auto append = [&text](std::string_view symbol, int exponent) {
    if (exponent == 0) return;
    if (!text.empty()) text += ' ';
    text += exponent == 1 ? std::string(symbol) : fmt::format("{}^{}", symbol, exponent);
  };
  append("kg", dimension.kilogram);
  append("m", dimension.metre);
  append("s", dimension.second);
  append("rad", dimension.radian);
  return text;
}

std::string example_of(const Dimension& dimension) {
  if (const Named* found = find_named(dimension)) return std::string(found->example);
  return "2 " + unit_of(dimension);
}

namespace {

/// Reads a quantity. `example` shows in a message what could stand in its place.
Quantity read_quantity(std::string_view text, std::string_view example) {
  std::string_view number = text;
  while (!number.empty() && (number.front() == ' ' || number.front() == '\t')) number.remove_prefix(1);
  if (number.starts_with('+') && !number.starts_with("+-")) number.remove_prefix(1);
  Quantity quantity;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), quantity.value);
  if (error == std::errc::result_out_of_range) fail(text, "is too large or too small for a number");
  if (error != std::errc{})
    fail(text, fmt::format("does not begin with a number; write, for example, \"{}\"", example));
  if (!std::isfinite(quantity.value)) fail(text, "is not a finite number");
  UnitReader(text, number.substr(static_cast<std::size_t>(end - number.data()))).read(quantity);
  if (!std::isfinite(quantity.value)) fail(text, "is too large for a number in SI units");
  return quantity;
}

}  // namespace

Quantity parse_quantity(std::string_view text) { return read_quantity(text, "3 kPa"); }

double parse_quantity(std::string_view text, const Dimension& expected, std::string_view likely_unit) {
  const Quantity quantity = read_quantity(text, example_of(expected));
  if (quantity.has_unit && quantity.dimension != expected)
    fail(text, fmt::format("is {}, but {} is expected, such as \"{}\"", name_of(quantity.dimension), name_of(expected),
                           example_of(expected)));
  if (!quantity.has_unit && needs_unit(quantity.value, expected)) {
    const std::size_t first = text.find_first_not_of(" \t"), last = text.find_last_not_of(" \t");
    fail(text, missing_unit(text.substr(first, last + 1 - first), quantity.value, expected, likely_unit));
  }
  return quantity.value;
}

bool needs_unit(double value, const Dimension& dimension) {
  return dimension != dimension::dimensionless && std::isfinite(value) && value != 0.0;
}

std::string missing_unit(std::string_view number, double value, const Dimension& dimension,
                         std::string_view likely_unit) {
  const Named* found = find_named(dimension);
  const std::string unit = unit_of(dimension);
  if (likely_unit.empty() && found != nullptr) likely_unit = found->usual;
  const std::string degrees =
      dimension == dimension::angle ? fmt::format(" = {:.4g} deg", value * 180.0 / std::numbers::pi) : "";
  const std::string likely = likely_unit.empty() ? "" : fmt::format("\"{} {}\" or ", number, likely_unit);
  return fmt::format("has no unit: it would be {0} {1}{2}; write {3}\"{0} {1}\"", number, unit, degrees, likely);
}

}  // namespace flowslide
