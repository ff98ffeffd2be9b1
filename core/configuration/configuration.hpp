// SPDX-License-Identifier: GPL-2.0-or-later
// The configuration of a run: TOML files in layers. Each value is checked for type, dimension and range, each key for
// its spelling.
#pragma once

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "configuration/entry.hpp"
#include "configuration/layers.hpp"
#include "configuration/quantity.hpp"
#include "configuration/range.hpp"

namespace flowslide {

/// A value that a user file (--config), --set or another option has changed.
struct Change {
  std::string key;
  std::string value;   ///< the new value: a text as written, "3 deg"; another value in the form of resolved()
  std::string before;  ///< the value of the case file or its base, as written; empty: they have no such key
};

/// A configuration. Each getter throws ConfigurationError if the key is missing, or if its value is of the wrong type,
/// of the wrong dimension or out of range. The message gives file, line, column, key, the value as written, the allowed
/// values and the remedy. The code has no defaults: the case file (case.toml) or its base sets every required key.
/// Several cases share one base, so a case need not read all keys of its base.
///
/// A key is a path such as "sample.confining_stress". An array of tables counts as a table whose keys are the
/// positions, from 0: "claim.0.metric". A later layer is merged into tables key by key. It replaces a list or an array
/// of tables as a whole.
/// Keys are bare: letters, digits, "_" and "-". At the top level, the table `scale` and the text `base` are reserved.
/// Getters mark the key as known, also when they throw. One thread at a time may use a configuration.
class Configuration {
 public:
  /// Reads all layers. Throws as `lay`.
  explicit Configuration(const Layers& layers);
  /// A configuration of one layer, from a text. Messages name `origin` in place of a file.
  static Configuration from_text(std::string_view toml, std::string origin = "text");

  /// A copy of this configuration with one more layer, which wins over the others.
  Configuration overlaid(std::string_view toml, const std::string& origin) const;

  /// A copy in which `key` has the value at `list`: item `item` (from 0) of a list, or a single value (item 0).
  /// Messages name the place of this item. No value of the copy counts as read. Tables above `key` that do not exist
  /// are added as tables of the case. Throws ConfigurationError if `list` is missing and as overlay(),
  /// std::out_of_range if there is no such item.
  Configuration with_item(const std::string& key, std::string_view list, std::size_t item) const;
  /// Records what was asked of `variant`, a copy of this configuration from with_item(): the keys that are known, and
  /// the values that were read, except those that the variant replaces.
  void adopt(const Configuration& variant) const;
  /// Keys of the values and lists below a table, without its name, in the order of the files; empty if it is missing.
  /// Throws ConfigurationError if `table` is a value.
  std::vector<std::string> keys_below(std::string_view table) const;
  /// The items of a list, or the single value, as texts without quotes. Throws ConfigurationError.
  std::vector<std::string> items_of(std::string_view key) const;
  /// Whether the configuration has the key, and its value is a list.
  bool is_list(std::string_view key) const;
  /// Throws ConfigurationError with a reason if no getter has read the value of `key`, which exists.
  void require_effect(std::string_view key) const;

  /// Whether the configuration has the key, as a value or as a table. Marks the key as known.
  bool has(std::string_view key) const;
  /// Whether --config or an option gives a value at `key` or below it.
  bool is_users(std::string_view key) const;
  /// Whether --config or an option added this table, which neither the case file nor its base has.
  bool is_users_table(std::string_view table) const;
  /// The nearest table that --config or an option added: `table` itself or one above it. Empty: there is none.
  std::string users_table_of(std::string_view table) const;
  /// Whether the base of the case first defines this table, or gives this value and no later layer replaces it.
  bool is_of_base(std::string_view key) const;

  /// A number in SI units, from a text such as "3 kPa". A bare number is allowed only if it is 0 or if the quantity is
  /// dimensionless.
  double quantity(std::string_view key, const Dimension& dimension, const Range& range = Range::any()) const;
  /// A number without unit; "25 %" is 0.25.
  double number(std::string_view key, const Range& range = Range::any()) const;
  std::int64_t integer(std::string_view key, const Range& range = Range::any()) const;
  bool flag(std::string_view key) const;
  /// A text. It must be one of `allowed` unless `allowed` is empty.
  std::string text(std::string_view key, const std::vector<std::string>& allowed = {}) const;

  /// The value that `values` gives for the text at `key`. Any text that is not a name in `values` is refused.
  template <typename Value>
  Value choice(std::string_view key, const std::vector<std::pair<std::string, Value>>& values) const;
  /// The path of a file. A relative path in a configuration file starts at the folder of that file; in an option it
  /// starts at the current folder.
  std::filesystem::path path(std::string_view key) const;

  /// Lists. A single value counts as a list of one. An empty list is refused.
  std::vector<double> quantities(std::string_view key, const Dimension& dimension,
                                 const Range& range = Range::any()) const;
  std::vector<double> numbers(std::string_view key, const Range& range = Range::any()) const;
  std::vector<std::int64_t> integers(std::string_view key, const Range& range = Range::any()) const;
  std::vector<std::string> texts(std::string_view key, const std::vector<std::string>& allowed = {}) const;

  /// Names of the tables below a key, in the order of the files; "0", "1", ... for an array of tables. Empty if the key
  /// does not exist. The keys below the table `name` start with `key + "." + name + "."`.
  std::vector<std::string> subtables(std::string_view key) const;

  /// Marks a key as known although this run does not need it. For a table, marks all keys below it too. With `reason`,
  /// a clause that says why the key has no effect, reject_unknown() refuses a value of the user that no getter read.
  void accept(std::string_view key, std::string_view reason = {}) const;
  /// Tells reject_unknown() which runs use a key, also in cases without such runs. `pattern` is a key in which "*"
  /// stands for any name: "sample.*.drag". `users` completes "it belongs to ...": "slides, which are runs with a
  /// scheme".
  void describe_users(std::string_view pattern, std::string_view users) const;

  /// Records that a reader used the value of `nearer` in place of the value of `key`. Another reader may still read
  /// `key`.
  void override_by(const std::string& key, const std::string& nearer) const { overridden_[key] = nearer; }

  /// Records that a reader used the value of `source` for `key`, which its table takes from another one by `like`.
  void inherit(const std::string& key, const std::string& source) const { inherited_[key] = source; }

  /// Where to look for the reason why values below these tables do not fit together: place, key and value of each that
  /// --config or an option gives. If there is none, the place of the first of these tables. A key may stand in place of
  /// a table.
  std::string place_of(const std::vector<std::string>& tables) const;

  /// Throws ConfigurationError about the value of `key`, for a rule that involves several keys. The message gives file,
  /// line, column, key and the value as written, then `problem` and `remedy` (clauses without a full stop).
  [[noreturn]] void refuse(std::string_view key, std::string_view problem, std::string_view remedy) const;

  /// Throws ConfigurationError if any layer has the old name `key`, whose present name is `now`. This includes the
  /// tables [scale.<name>] that were not chosen. The message gives file, line, column and both names.
  void refuse_renamed(std::string_view key, std::string_view now) const;

  /// Throws ConfigurationError if a layer other than the base has a key that no getter asked for. This includes the
  /// tables [scale.<name>] that were not chosen. Throws too if --config or an option gives a value that has no effect
  /// because every reader used a nearer key. The message gives file, line and column of each key, and for an unknown
  /// key the nearest known one, or which runs would use it. Call it after all values are read.
  void reject_unknown() const;

  /// Whether the case file or its base has the key at the chosen scale.
  bool is_published(std::string_view key) const;
  /// The values that were read and that differ from the case file with its base at the chosen scale, or that these
  /// files do not have. Quantities are compared as texts: "3 kPa" and "3000 Pa" differ.
  std::vector<Change> changes() const;

  /// All values that were read, as canonical TOML: one line per dotted key, sorted, each number in canonical form.
  /// Quantities are texts with their SI unit, "28340.0 Pa"; counts and ratios have no unit. Reading this text gives the
  /// same configuration.
  std::string resolved() const;
  /// The lines of resolved(), each with the source of its value as a comment: "# cases/paper.toml:12".
  std::string resolved_with_origins() const;
  /// The values that tables below `list` take from others by `like`, one line each: `sample.b.drag = "0.06 kg/s"`, then
  /// the table and the source of the value as a comment.
  std::string inherited_with_origins(std::string_view list) const;

 private:
  Configuration() = default;
  using Lines = std::map<std::string, std::string, KeyOrder>;
  bool is_published_origin(const Entry& entry) const;
  Lines resolved_lines() const;
  void index_entries();
  const Entry* find(std::string_view key) const;
  const Entry& require(std::string_view key, std::string_view wanted) const;
  const Entry& require_value(std::string_view key, std::string_view wanted) const;
  std::vector<Scalar> require_items(std::string_view key, std::string_view wanted) const;
  bool is_known(const std::string& key) const;
  bool is_known_elsewhere(const std::string& key) const;
  std::string with_wildcards(std::string_view key) const;
  std::string unknown_message(const Entry& entry) const;
  std::string users_of(const Entry& entry) const;
  std::string origin_of(const std::string& key) const;
  std::string reason_for_no_effect(const Entry& entry) const;

  std::string origin_;                                   ///< the case file
  std::string users_file_;                               ///< the file of --config; empty: none
  std::string base_;                                     ///< the base of the case file; empty: none
  std::vector<Entry> entries_;                           ///< in file order, parents before children
  std::map<std::string, std::size_t, std::less<>> positions_;  ///< key -> its index in entries_
  std::vector<Entry> published_;                         ///< entries of the case file and its base at this scale
  std::vector<Entry> unselected_;                        ///< entries of other scales: checked for spelling only
  mutable std::set<std::string, std::less<>> known_;     ///< keys that a getter asked for: values and tables
  mutable std::map<std::string, std::string, std::less<>> accepted_;  ///< keys not needed -> why; with all keys below
  mutable std::map<std::string, std::string> users_;                  ///< pattern of keys -> the runs that use them
  mutable std::map<std::string, std::string> inherited_;              ///< key -> the key whose value it has by `like`
  mutable std::set<std::string, std::less<>> listed_;    ///< tables whose names subtables() returned
  mutable std::map<std::string, std::string> overridden_;  ///< key -> the nearer key that was used instead
  mutable Lines resolved_;                                 ///< key -> canonical value with its unit
};

template <typename Value>
Value Configuration::choice(std::string_view key, const std::vector<std::pair<std::string, Value>>& values) const {
  std::vector<std::string> names;
  for (const auto& [name, value] : values) names.push_back(name);
  const auto given = std::find(names.begin(), names.end(), text(key, names));
  return values.at(static_cast<std::size_t>(given - names.begin())).second;
}

}  // namespace flowslide
