// SPDX-License-Identifier: GPL-2.0-or-later
#include "configuration/entry_reader.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cctype>
#include <utility>

#include "configuration/error.hpp"
#include "configuration/nesting.hpp"
#include "configuration/text_file.hpp"

namespace flowslide {
namespace {

bool is_bare(std::string_view key) {
  const auto allowed = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '-'; };
  return !key.empty() && std::all_of(key.begin(), key.end(), allowed);
}

[[noreturn]] void refuse_key(const Place& place, std::string_view key) {
  throw ConfigurationError(
      fmt::format("{}: the key \"{}\" is not bare: use letters, digits, \"_\" and \"-\" only", place.text(), key));
}

/// Finds parts of a text by the positions of the TOML library, whose columns count code points.
class SourceText {
 public:
  explicit SourceText(std::string_view text) : text_(text) {}

  /// The text between two positions. Of several lines it returns the first, followed by " ...".
  std::string between(const toml::source_position& begin, const toml::source_position& end) const {
    const std::size_t first = offset(begin);
    std::string_view slice = text_.substr(first, offset(end) - first);
    const bool more = slice.find('\n') != std::string_view::npos;
    slice = slice.substr(0, slice.find_first_of("\r\n"));
    while (!slice.empty() && (slice.back() == ' ' || slice.back() == '\t')) slice.remove_suffix(1);
    return std::string(slice) + (more ? " ..." : "");
  }

  /// The character at a position; '\0' after the end of the text.
  char at(const toml::source_position& position) const {
    const std::size_t place = offset(position);
    return place < text_.size() ? text_[place] : '\0';
  }

 private:
  std::size_t offset(const toml::source_position& position) const {
    std::size_t at = 0;
    for (toml::source_index line = 1; line < position.line && at < text_.size(); ++line)
      at = std::min(text_.find('\n', at), text_.size() - 1) + 1;
    for (toml::source_index column = 1; column < position.column && at < text_.size(); ++column) {
      do ++at;
      while (at < text_.size() && (static_cast<unsigned char>(text_[at]) & 0xC0U) == 0x80U);
    }
    return at;
  }

  std::string_view text_;
};

ScalarValue value_of(const toml::node& node) {
  if (const auto* flag = node.as_boolean()) return flag->get();
  if (const auto* integer = node.as_integer()) return integer->get();
  if (const auto* number = node.as_floating_point()) return number->get();
  if (const auto* text = node.as_string()) return text->get();
  return std::monostate{};
}

/// Turns a tree of TOML nodes into a flat list of entries.
class Flattener {
 public:
  Flattener(std::string_view text, std::string origin) : source_(text), origin_(std::move(origin)) {}

  std::vector<Entry> flatten(const toml::table& root) {
    add_members(root, "");
    return std::move(entries_);
  }

 private:
  Place place_of(const toml::source_position& position) const { return {origin_, position.line, position.column}; }

  Scalar scalar_of(const toml::node& node) const {
    const toml::source_region& region = node.source();
    return {value_of(node), place_of(region.begin), source_.between(region.begin, region.end)};
  }

  void add_members(const toml::table& table, const std::string& prefix) {
    std::vector<std::pair<toml::source_position, std::string_view>> order;
    for (const auto& [key, node] : table) order.emplace_back(key.source().begin, key.str());
    std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [position, key] : order) {
      if (!is_bare(key)) refuse_key(place_of(position), key);
      add(prefix + std::string(key), place_of(position), *table.get(key));
    }
  }

  void add(const std::string& key, const Place& key_place, const toml::node& node) {
    Entry entry{.key = key, .kind = Entry::Kind::value, .key_place = key_place, .whole = scalar_of(node), .items = {}};
    if (const toml::table* table = node.as_table()) {
      entry.kind = Entry::Kind::table;
      entries_.push_back(std::move(entry));
      add_members(*table, key + ".");
    } else if (const toml::array* array = node.as_array()) {
      add_list(std::move(entry), *array);
    } else {
      entries_.push_back(std::move(entry));
    }
  }

  void add_list(Entry entry, const toml::array& array) {
    if (!array.empty() && array.is_homogeneous(toml::node_type::table)) {
      entry.kind = Entry::Kind::table;
      entry.list_of_tables = true;
      const std::string key = entry.key;
      entries_.push_back(std::move(entry));
      for (std::size_t i = 0; i < array.size(); ++i)
        add(fmt::format("{}.{}", key, i), place_of(array[i].source().begin), array[i]);
      return;
    }
    entry.kind = Entry::Kind::list;
    for (const toml::node& item : array) entry.items.push_back(scalar_of(item));
    entries_.push_back(std::move(entry));
  }

  SourceText source_;
  std::string origin_;
  std::vector<Entry> entries_;
};

[[noreturn]] void refuse_nesting(const std::string& place) {
  throw ConfigurationError(
      fmt::format("{0}: is nested too deeply: a key may have {1} parts at most, and {1} brackets at most may be nested",
                  place, most_nesting));
}

/// Line and column of a byte offset in a text. Columns count code points.
Place place_of(std::string_view text, std::size_t offset, const std::string& origin) {
  const std::string_view before = text.substr(0, offset);
  const std::string_view line = before.substr(before.rfind('\n') + 1);
  const auto begins = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; };
  return {origin, 1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n')),
          1 + static_cast<std::size_t>(std::count_if(line.begin(), line.end(), begins))};
}

/// The message of the TOML library, except for a string that is not closed. There the library complains about the
/// character after the line, so this function names the missing quote.
std::string explanation(const toml::parse_error& error, std::string_view text) {
  const std::string_view own = error.description();
  const char at = SourceText(text).at(error.source().begin);
  const bool in_string = own.find("string") != std::string_view::npos;
  if (in_string && (at == '\n' || at == '\r')) return "a text is not closed: its second quote is missing in this line";
  if (in_string && at == '\0') return "a text is not closed: its second quote is missing";
  return std::string(own);
}

constexpr std::size_t most_shown = 60;  ///< characters of an option in a message; the rest is cut off

/// Whether a value begins like a list, a table or a quoted text of TOML.
bool begins_as_toml(std::string_view value) {
  const std::size_t first = value.find_first_not_of(" \t");
  return first != std::string_view::npos && std::string_view("[{\"'").find(value[first]) != std::string_view::npos;
}

void relocate(Entry& entry, const std::string& option) {
  entry.key_place = entry.whole.place = {.origin = option};
  for (Scalar& item : entry.items) item.place = {.origin = option};
}

}  // namespace

std::vector<Entry> read_entries(std::string_view toml, const std::string& origin) {
  if (const auto offset = too_deep_at(toml)) refuse_nesting(place_of(toml, *offset, origin).text());
  try {
    return Flattener(toml, origin).flatten(toml::parse(toml, origin));
  } catch (const toml::parse_error& error) {
    const Place place{origin, error.source().begin.line, error.source().begin.column};
    throw ConfigurationError(fmt::format("{}: this is not TOML: {}", place.text(), explanation(error, toml)));
  }
}

std::vector<Entry> read_entries(const std::filesystem::path& file) {
  return read_entries(read_text_file(file, "a TOML file"), file.string());
}

std::vector<Entry> read_option(const std::string& key, const std::string& value, const std::string& option) {
  if (std::count(key.begin(), key.end(), '.') >= most_nesting || too_deep_at(value))
    refuse_nesting(option.size() <= most_shown ? option : option.substr(0, most_shown) + "...");
  std::vector<Entry> entries;
  for (std::size_t dot = key.find('.'); dot != std::string::npos; dot = key.find('.', dot + 1)) {
    Entry table;
    table.key = key.substr(0, dot);
    table.kind = Entry::Kind::table;
    entries.push_back(std::move(table));
  }
  std::vector<Entry> values;
  try {
    const std::string line = "value = " + value;
    values = read_entries(line, option);
  } catch (const ConfigurationError&) {
    if (begins_as_toml(value))
      throw ConfigurationError(
          fmt::format("{}: the value is not TOML: close every quote and bracket, and quote each text "
                      "of a list, such as [\"0.2 1/s\", \"0.1 1/s\"]",
                      option));
    values.clear();
  }
  const bool one_value = !values.empty() && values.front().key == "value" &&
                         std::all_of(values.begin() + 1, values.end(),
                                     [](const Entry& entry) { return stands_below(entry.key, "value"); });
  if (!one_value) {
    values.assign(1, Entry{});
    values.front().key = "value";
    values.front().whole.value = value;
    values.front().whole.written = value;
  }
  for (Entry& entry : values) {
    entry.key.replace(0, std::string_view("value").size(), key);
    entries.push_back(std::move(entry));
  }
  for (Entry& entry : entries) {
    relocate(entry, option);
    const std::size_t dot = entry.key.rfind('.');
    if (!is_bare(entry.key.substr(dot == std::string::npos ? 0 : dot + 1))) refuse_key({.origin = option}, key);
  }
  return entries;
}

}  // namespace flowslide
