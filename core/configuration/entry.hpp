// SPDX-License-Identifier: GPL-2.0-or-later
// A flat list of the keys of a TOML file, each with its place in the file. Configuration is built on such lists.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace flowslide {

/// The place where a key or a value was written.
struct Place {
  std::string origin;      ///< a file, or an option such as "--set a=1"
  std::size_t line = 0;    ///< from 1; 0: the origin has no lines
  std::size_t column = 0;  ///< from 1

  /// "case.toml:3:7", or the origin alone when it has no lines.
  std::string text() const;
};

/// A value of a type that Configuration supports. std::monostate: a TOML type that it does not (dates, nested lists).
using ScalarValue = std::variant<std::monostate, bool, std::int64_t, double, std::string>;

/// One value with its place and its text as written.
struct Scalar {
  ScalarValue value;
  Place place;
  std::string written;
};

/// One key with its value, list or table.
struct Entry {
  enum class Kind { value, list, table };

  std::string key;  ///< whole path, "sample.confining_stress"
  Kind kind = Kind::value;
  Place key_place;              ///< place of the key itself
  Scalar whole;                 ///< the value; for a list or a table its place and text only
  std::vector<Scalar> items;    ///< items of a list
  bool list_of_tables = false;  ///< true: this table represents an array of tables
};

/// Orders keys part by part. Parts made of digits are ordered as numbers: "point.2" before "point.10".
struct KeyOrder {
  bool operator()(std::string_view a, std::string_view b) const;
};

/// Lays `layer` over `base`: merges tables key by key, replaces values, lists and arrays of tables. Throws
/// ConfigurationError if one has a table where the other has a value or a list.
void overlay(std::vector<Entry>& base, const std::vector<Entry>& layer);

/// Removes the entry `prefix` and all entries below it from `entries`. Returns the entries below it, their keys without
/// the prefix.
std::vector<Entry> take_below(std::vector<Entry>& entries, const std::string& prefix);

/// Whether `key` lies below the table `table`: "a.b" lies below "a".
bool stands_below(std::string_view key, std::string_view table);

}  // namespace flowslide
