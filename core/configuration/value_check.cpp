// SPDX-License-Identifier: GPL-2.0-or-later
#include "configuration/value_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "configuration/error.hpp"
#include "configuration/nearest.hpp"

namespace flowslide {
namespace {

std::string_view type_of(const Scalar& scalar) {
  struct Name {
    std::string_view operator()(std::monostate) const { return "a date, a list or a table"; }
    std::string_view operator()(bool) const { return "true or false"; }
    std::string_view operator()(std::int64_t) const { return "an integer"; }
    std::string_view operator()(double) const { return "a number"; }
    std::string_view operator()(const std::string&) const { return "text"; }
  };
  return std::visit(Name{}, scalar.value);
}

[[noreturn]] void refuse_type(std::string_view key, const Scalar& scalar, std::string_view wanted,
                              std::string_view example) {
  refuse_value(key, scalar, fmt::format("is {}, but {} is needed", type_of(scalar), wanted),
               fmt::format("write, for example, {}", example));
}

void check_range(std::string_view key, const Scalar& scalar, double value, const Dimension& dimension,
                 const Range& range) {
  if (range.contains(value)) return;
  refuse_value(key, scalar, fmt::format("is not allowed: it must be {}", range.describe(dimension)),
               scalar.place.line == 0 ? "give another" : "change it there or give another with --set");
}

/// 2^53. Beyond it a double does not represent every integer, so a larger double is not read as an integer.
constexpr double largest_exact_integer = 9007199254740992.0;

}  // namespace

void refuse_value(std::string_view key, const Scalar& scalar, std::string_view problem, std::string_view remedy) {
  const bool from_option = scalar.place.line == 0;  // the place of an option includes key and value
  const std::string what = from_option ? "the value" : fmt::format("{} = {}", key, scalar.written);
  throw ConfigurationError(
      fmt::format("{}: {} {}{}{}", scalar.place.text(), what, problem, remedy.empty() ? "" : "; ", remedy));
}

std::string wanted_quantity(const Dimension& dimension, const Range& range) {
  const bool bounded = std::isfinite(range.lowest) || std::isfinite(range.highest);
  return bounded ? fmt::format("{}, {}", name_of(dimension), range.describe(dimension)) : name_of(dimension);
}

double checked_quantity(std::string_view key, const Scalar& scalar, const Dimension& dimension, const Range& range) {
  double value = 0.0;
  const auto* number = std::get_if<double>(&scalar.value);
  const auto* integer = std::get_if<std::int64_t>(&scalar.value);
  if (number != nullptr || integer != nullptr) {
    value = number != nullptr ? *number : static_cast<double>(*integer);
    if (needs_unit(value, dimension)) refuse_value(key, scalar, missing_unit(scalar.written, value, dimension));
  } else if (const auto* text = std::get_if<std::string>(&scalar.value)) {
    try {
      value = parse_quantity(*text, dimension);
    } catch (const std::invalid_argument& error) {
      throw ConfigurationError(fmt::format("{}: {}: {}", scalar.place.text(), key, error.what()));
    }
  } else {
    refuse_type(key, scalar, wanted_quantity(dimension, range), '"' + example_of(dimension) + '"');
  }
  check_range(key, scalar, value, dimension, range);
  return value;
}

std::int64_t checked_integer(std::string_view key, const Scalar& scalar, const Range& range) {
  std::int64_t value = 0;
  if (const auto* integer = std::get_if<std::int64_t>(&scalar.value)) {
    value = *integer;
  } else if (const auto* number = std::get_if<double>(&scalar.value);
             number != nullptr && std::abs(*number) <= largest_exact_integer && std::trunc(*number) == *number) {
    value = static_cast<std::int64_t>(*number);
  } else if (number != nullptr) {
    refuse_value(key, scalar, "is not an integer", "write a number without fraction");
  } else {
    refuse_type(key, scalar, "an integer", "20");
  }
  check_range(key, scalar, static_cast<double>(value), dimension::dimensionless, range);
  return value;
}

std::string checked_text(std::string_view key, const Scalar& scalar, const std::vector<std::string>& allowed) {
  const auto* text = std::get_if<std::string>(&scalar.value);
  if (text == nullptr) refuse_type(key, scalar, "text", '"' + (allowed.empty() ? "text" : allowed.front()) + '"');
  if (!allowed.empty() && std::find(allowed.begin(), allowed.end(), *text) == allowed.end()) {
    refuse_value(key, scalar, fmt::format("is not allowed: it must be {}", list_of(allowed)),
                 did_you_mean(*text, allowed, "choose one of these"));
  }
  return *text;
}

bool checked_flag(std::string_view key, const Scalar& scalar) {
  const auto* flag = std::get_if<bool>(&scalar.value);
  if (flag == nullptr) refuse_type(key, scalar, "true or false", "true");
  return *flag;
}

}  // namespace flowslide
