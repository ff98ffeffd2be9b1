// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <filesystem>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "configuration/configuration.hpp"

namespace flowslide {

/// Names of the tables in which a key is looked up, in this order: "point.pulse.loading", then "loading".
class TableNames {
 public:
  TableNames(const char* name) : names_{name} {}
  TableNames(std::string name) : names_{std::move(name)} {}
  TableNames(std::initializer_list<std::string> names) : names_(names) {}
  TableNames(std::vector<std::string> names) : names_(std::move(names)) {}

  const std::vector<std::string>& names() const { return names_; }

 private:
  std::vector<std::string> names_;
};

/// The getters of Configuration for such tables. A key is read from the first table that has it. The message about a
/// missing key names the first table that the user added; else the first that would lie below such a table; else the
/// last.
class Tables {
 public:
  /// `configuration` must outlive it.
  Tables(const Configuration& configuration, TableNames tables)
      : configuration_(configuration), tables_(std::move(tables)) {}

  /// The whole key: the first table that has it, then `name`.
  std::string key(const char* name) const;
  bool has(const char* name) const { return configuration_.has(key(name)); }
  std::string text(const char* name, const std::vector<std::string>& allowed = {}) const {
    return configuration_.text(key(name), allowed);
  }
  std::filesystem::path path(const char* name) const { return configuration_.path(key(name)); }
  template <typename Value>
  Value choice(const char* name, const std::vector<std::pair<std::string, Value>>& values) const {
    return configuration_.choice(key(name), values);
  }
  double number(const char* name, const Range& range) const { return configuration_.number(key(name), range); }
  double quantity(const char* name, const Dimension& dimension, const Range& range = Range::any()) const {
    return configuration_.quantity(key(name), dimension, range);
  }
  double positive(const char* name, const Dimension& dimension) const {
    return quantity(name, dimension, Range::positive());
  }
  std::int64_t integer(const char* name, const Range& range) const { return configuration_.integer(key(name), range); }
  std::vector<double> quantities(const char* name, const Dimension& dimension, const Range& range) const {
    return configuration_.quantities(key(name), dimension, range);
  }
  std::vector<std::int64_t> integers(const char* name, const Range& range) const {
    return configuration_.integers(key(name), range);
  }
  bool flag(const char* name) const { return configuration_.flag(key(name)); }
  /// Marks these keys as known in all tables. `reason` says why they have no effect (see Configuration::accept).
  void accept(std::initializer_list<const char*> names, const std::string& reason = {}) const;
  [[noreturn]] void refuse(const char* name, const std::string& problem, const std::string& remedy) const {
    configuration_.refuse(key(name), problem, remedy);
  }

 private:
  /// The table that a message about a missing key names.
  const std::string& table_to_complete() const;

  const Configuration& configuration_;
  TableNames tables_;
};

/// The tables in which keys of [<list>.<name>] are looked up: the table itself; with `like = "other"`, then
/// [<list>.other]; and so on for its own `like`. Throws ConfigurationError if a table does not exist, or if the chain
/// of `like` returns to one of its tables.
std::vector<std::string> with_like(const Configuration& configuration, const std::string& list,
                                   const std::string& name);

/// Order of lookup: the tables `name` below each of `tables`, then `others`.
TableNames within(std::vector<std::string> tables, const std::string& name, const std::vector<std::string>& others);

}  // namespace flowslide
