// SPDX-License-Identifier: GPL-2.0-or-later
// What a run is asked to do: TOML in layers, read once, checked for type, dimension, range and spelling.
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

/// A value that --config, --set or another option has changed.
struct Change {
  std::string key;
  std::string value;   ///< as resolved() has it: "28340.0 Pa"
  std::string before;  ///< as the case file has it, as written; empty where that has none
};

/// A configuration. Each getter throws ConfigurationError when the key is missing, of the wrong type, of the wrong
/// dimension or out of range; the message gives file, line, column, key, the value as written, what is allowed and how
/// to mend it. There are no defaults in code: what a run may be asked stands in its case.toml and the base of that.
/// Several cases share a base, so that a key of the base may be left unread.
///
/// A key is a path such as "sample.confining_stress". An array of tables counts as a table whose keys are the
/// positions, from 0: "claim.0.metric". A later layer overlays tables key by key and replaces lists (of tables too)
/// as a whole.
/// Keys are bare: letters, digits, "_" and "-". At the top, the table `scale` and the text `base` are reserved.
/// Getters mark the key as known, also when they throw. Not for use by several threads at once.
class Configuration {
 public:
  /// Reads all layers. Throws ConfigurationError when a file cannot be read, is not TOML (file, line and column), has
  /// no such scale, has a base where it may not have one, or puts a table where another layer has a value or the other
  /// way round.
  explicit Configuration(const Layers& layers);
  /// A single layer from a text; `origin` stands for the file in messages.
  static Configuration from_text(std::string_view toml, std::string origin = "text");

  /// This configuration under one more layer.
  Configuration overlaid(std::string_view toml, const std::string& origin) const;

  /// Whether the key, a value or a table, is there. Marks it as known.
  bool has(std::string_view key) const;
  /// Whether a table is there that neither the case file nor its base has: --config or --set brought it.
  bool is_users_table(std::string_view table) const;
  /// Whether the case's base brought the table or value, as far as it is in no later layer.
  bool is_of_base(std::string_view key) const;

  /// A number in SI units, from a text such as "3 kPa". A bare number is refused, but 0 and where the dimension has no
  /// unit.
  double quantity(std::string_view key, const Dimension& dimension, const Range& range = Range::any()) const;
  /// A number without unit; "25 %" is 0.25.
  double number(std::string_view key, const Range& range = Range::any()) const;
  std::int64_t integer(std::string_view key, const Range& range = Range::any()) const;
  bool flag(std::string_view key) const;
  /// A text; one of `allowed` unless that is empty.
  std::string text(std::string_view key, const std::vector<std::string>& allowed = {}) const;

  /// The value whose name the text is; another text is refused. There is no other list of the names.
  template <typename Value>
  Value choice(std::string_view key, const std::vector<std::pair<std::string, Value>>& values) const;
  /// The path of a file; a relative one is resolved beside the file that names it, or in the current folder if an
  /// option does.
  std::filesystem::path path(std::string_view key) const;

  /// Lists; a single value counts as a list of one. An empty list is refused.
  std::vector<double> quantities(std::string_view key, const Dimension& dimension,
                                 const Range& range = Range::any()) const;
  std::vector<double> numbers(std::string_view key, const Range& range = Range::any()) const;
  std::vector<std::int64_t> integers(std::string_view key, const Range& range = Range::any()) const;
  std::vector<std::string> texts(std::string_view key, const std::vector<std::string>& allowed = {}) const;

  /// Names of the tables under a key in the order of the files, "0", "1", ... for an array of tables; empty when the
  /// key is not there. The values of one of them have the key `key + "." + name + "." + ...`.
  std::vector<std::string> subtables(std::string_view key) const;

  /// Marks a key, and if it is a table all below it, as known though this scene does not need it.
  void accept(std::string_view key) const;

  /// Says that a reader took the value of `nearer` in place of that of `key`; another may still read `key`.
  void override_by(const std::string& key, const std::string& nearer) const { overridden_[key] = nearer; }

  /// Throws a ConfigurationError about the value of a key that a getter has read, for a rule that spans several keys:
  /// file, line, column, key, the value as written, then `problem` and `mend` (whole clauses without full stop).
  [[noreturn]] void refuse(std::string_view key, std::string_view problem, std::string_view mend) const;

  /// Throws ConfigurationError when any layer, also a [scale] that was not chosen, has `key`: its name is `now` since.
  /// The message gives file, line, column and both names.
  void refuse_renamed(std::string_view key, std::string_view now) const;

  /// Throws ConfigurationError when any layer, also a [scale] that was not chosen, has a key that no getter asked for:
  /// file, line and column of each, with the nearest known key; or when --config or --set gives a value that all
  /// readers took from elsewhere. Call it once all is read.
  void reject_unknown() const;

  /// Whether the case file or its base has the key at this scale.
  bool is_published(std::string_view key) const;
  /// The values that were read and that the case file and its base, at this scale, lack or have otherwise. A value in
  /// another unit counts as another.
  std::vector<Change> changes() const;

  /// All that was read, as canonical TOML: dotted keys, sorted, numbers in the shortest form that gives the same double
  /// again. Quantities are texts with their SI unit, "28340.0 Pa"; counts and ratios are bare. Reading this text gives
  /// the same configuration.
  std::string resolved() const;
  /// The lines of resolved(), each with the layer that its value came from as a comment: "# cases/paper.toml:12".
  std::string resolved_with_origins() const;

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
  bool is_in_vain(const Entry& entry) const;

  std::string origin_;                                   ///< the case file
  std::string base_;                                     ///< the file below the case file; empty when it has none
  std::vector<Entry> entries_;                           ///< in file order, parents before children
  std::map<std::string, std::size_t, std::less<>> positions_;  ///< of the keys in entries_
  std::vector<Entry> published_;                         ///< those of the case file and its base at this scale
  std::vector<Entry> unselected_;                        ///< of scales that were not chosen: checked for spelling only
  mutable std::set<std::string, std::less<>> known_;     ///< keys asked for, values and tables
  mutable std::set<std::string, std::less<>> accepted_;  ///< keys not needed, with all below them
  mutable std::set<std::string, std::less<>> listed_;    ///< tables asked for by subtables()
  mutable std::map<std::string, std::string> overridden_;  ///< key -> a nearer one that stood in for it
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
