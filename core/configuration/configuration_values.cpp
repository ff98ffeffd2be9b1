// SPDX-License-Identifier: GPL-2.0-or-later
// The getters of Configuration: each finds a value, checks it and stores its canonical form for resolved().
#include <fmt/format.h>

#include <type_traits>

#include "configuration/canonical.hpp"
#include "configuration/configuration.hpp"
#include "configuration/error.hpp"
#include "configuration/nearest.hpp"
#include "configuration/value_check.hpp"

namespace flowslide {
namespace {

/// The value in SI units as a quoted text with its unit, "0.2 m"; as a number if it is dimensionless.
std::string canonical_quantity(double value, const Dimension& dimension) {
  const std::string unit = unit_of(dimension);
  return unit.empty() ? canonical(value) : fmt::format("\"{} {}\"", canonical(value), unit);
}

/// [a, b, c], each in canonical form.
template <typename T>
std::string canonical_list(const std::vector<T>& values, const Dimension& dimension = dimension::dimensionless) {
  std::vector<std::string> texts;
  for (const T& value : values) {
    if constexpr (std::is_same_v<T, double>)
      texts.push_back(canonical_quantity(value, dimension));
    else
      texts.push_back(canonical(value));
  }
  return fmt::format("[{}]", fmt::join(texts, ", "));
}

}  // namespace

const Entry& Configuration::require_value(std::string_view key, std::string_view wanted) const {
  const Entry& entry = require(key, wanted);
  if (entry.kind == Entry::Kind::table) {
    throw ConfigurationError(
        fmt::format("{}: {} is a table, but one value is needed: {}", entry.key_place.text(), key, wanted));
  }
  if (entry.kind == Entry::Kind::list)
    refuse_value(key, entry.whole, "is a list, but one value is needed", fmt::format("give {}", wanted));
  return entry;
}

std::vector<Scalar> Configuration::require_items(std::string_view key, std::string_view wanted) const {
  const Entry& entry = require(key, fmt::format("a list ({})", wanted));
  if (entry.kind == Entry::Kind::table) {
    throw ConfigurationError(
        fmt::format("{}: {} is a table, but a list is needed: {}", entry.key_place.text(), key, wanted));
  }
  if (entry.kind == Entry::Kind::value) return {entry.whole};
  if (entry.items.empty()) refuse_value(key, entry.whole, "is empty", fmt::format("give at least one: {}", wanted));
  return entry.items;
}

double Configuration::quantity(std::string_view key, const Dimension& dimension, const Range& range) const {
  const Entry& entry = require_value(key, wanted_quantity(dimension, range));
  const double value = checked_quantity(key, entry.whole, dimension, range);
  resolved_[entry.key] = canonical_quantity(value, dimension);
  return value;
}

double Configuration::number(std::string_view key, const Range& range) const {
  return quantity(key, dimension::dimensionless, range);
}

std::int64_t Configuration::integer(std::string_view key, const Range& range) const {
  const Entry& entry = require_value(key, "an integer, " + range.describe());
  const std::int64_t value = checked_integer(key, entry.whole, range);
  resolved_[entry.key] = canonical(value);
  return value;
}

bool Configuration::flag(std::string_view key) const {
  const Entry& entry = require_value(key, "true or false");
  const bool value = checked_flag(key, entry.whole);
  resolved_[entry.key] = canonical(value);
  return value;
}

std::string Configuration::text(std::string_view key, const std::vector<std::string>& allowed) const {
  const Entry& entry = require_value(key, allowed.empty() ? "text" : list_of(allowed));
  std::string value = checked_text(key, entry.whole, allowed);
  resolved_[entry.key] = canonical(std::string_view(value));
  return value;
}

std::filesystem::path Configuration::path(std::string_view key) const {
  const std::filesystem::path written = text(key);
  const Place& place = find(key)->whole.place;
  const bool in_file = place.line > 0;
  return in_file ? std::filesystem::path(place.origin).parent_path() / written : written;
}

std::vector<double> Configuration::quantities(std::string_view key, const Dimension& dimension,
                                              const Range& range) const {
  std::vector<double> values;
  for (const Scalar& item : require_items(key, "each " + wanted_quantity(dimension, range)))
    values.push_back(checked_quantity(key, item, dimension, range));
  resolved_[std::string(key)] = canonical_list(values, dimension);
  return values;
}

std::vector<double> Configuration::numbers(std::string_view key, const Range& range) const {
  return quantities(key, dimension::dimensionless, range);
}

std::vector<std::int64_t> Configuration::integers(std::string_view key, const Range& range) const {
  std::vector<std::int64_t> values;
  for (const Scalar& item : require_items(key, "each an integer, " + range.describe()))
    values.push_back(checked_integer(key, item, range));
  resolved_[std::string(key)] = canonical_list(values);
  return values;
}

std::vector<std::string> Configuration::texts(std::string_view key, const std::vector<std::string>& allowed) const {
  std::vector<std::string> values;
  for (const Scalar& item : require_items(key, allowed.empty() ? "each a text" : "each " + list_of(allowed)))
    values.push_back(checked_text(key, item, allowed));
  resolved_[std::string(key)] = canonical_list(values);
  return values;
}

}  // namespace flowslide
