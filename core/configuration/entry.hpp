// SPDX-License-Identifier: GPL-2.0-or-later
// TOML laid flat: one entry per key, with the place it came from. What Configuration is made of.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace flowslide {

/// Where something was written.
struct Place {
  std::string origin;      ///< a file, or an option such as "--set a=1"
  std::size_t line = 0;    ///< from 1; 0: the origin has no lines
  std::size_t column = 0;  ///< from 1

  /// "case.toml:3:7", or the origin alone when it has no lines.
  std::string text() const;
};

/// A value that configuration knows; std::monostate stands for those of TOML that it does not (dates, nested lists).
using ScalarValue = std::variant<std::monostate, bool, std::int64_t, double, std::string>;

/// One value with its place and its text as written.
struct Scalar {
  ScalarValue value;
  Place place;
  std::string written;
};

/// One key with what stands at it.
struct Entry {
  enum class Kind { value, list, table };

  std::string key;  ///< whole path, "sample.confining_stress"
  Kind kind = Kind::value;
  Place key_place;              ///< of the key itself
  Scalar whole;                 ///< the value, or place and text of the list or table
  std::vector<Scalar> items;    ///< of a list
  bool list_of_tables = false;  ///< a table that stands for an array of tables
};

/// Orders keys by their parts, parts made of digits by their number: "point.2" before "point.10".
struct KeyOrder {
  bool operator()(std::string_view a, std::string_view b) const;
};

/// Puts `layer` over `base`: tables are merged key by key, values and lists (of tables too) are replaced. Throws
/// ConfigurationError when one has a table where the other has a value.
void overlay(std::vector<Entry>& base, const std::vector<Entry>& layer);

/// Removes the entry `prefix` and all below it from `entries` and returns those below, the prefix taken off their keys.
std::vector<Entry> take_below(std::vector<Entry>& entries, const std::string& prefix);

/// Whether `key` stands below the table `table`: "a.b" stands below "a".
bool stands_below(std::string_view key, std::string_view table);

}  // namespace flowslide
