// SPDX-License-Identifier: GPL-2.0-or-later
#include "configuration/configuration.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "configuration/canonical.hpp"
#include "configuration/entry_reader.hpp"
#include "configuration/error.hpp"
#include "configuration/nearest.hpp"
#include "configuration/symbols.hpp"
#include "configuration/value_check.hpp"

namespace flowslide {
namespace {

/// Whether `key` matches `pattern`, in which a part "*" stands for any name.
bool matches(std::string_view key, std::string_view pattern) {
  while (true) {
    const std::size_t key_end = std::min(key.find('.'), key.size()), end = std::min(pattern.find('.'), pattern.size());
    if (pattern.substr(0, end) != "*" && pattern.substr(0, end) != key.substr(0, key_end)) return false;
    if (key_end == key.size() || end == pattern.size()) return key_end == key.size() && end == pattern.size();
    key.remove_prefix(key_end + 1);
    pattern.remove_prefix(end + 1);
  }
}

/// The first parts of `pattern`, as many as `table` has; empty unless more parts follow.
std::string_view beginning_like(std::string_view pattern, std::string_view table) {
  std::size_t end = pattern.find('.');
  for (auto dots = std::count(table.begin(), table.end(), '.'); dots > 0 && end != std::string_view::npos; --dots)
    end = pattern.find('.', end + 1);
  return pattern.substr(0, end == std::string_view::npos ? 0 : end);
}

}  // namespace

Configuration::Configuration(const Layers& layers)
    : origin_(layers.case_file.string()), users_file_(layers.user_file.value_or("").string()) {
  LaidEntries laid = lay(layers);
  base_ = std::move(laid.base);
  entries_ = std::move(laid.all);
  published_ = std::move(laid.published);
  unselected_ = std::move(laid.unselected);
  index_entries();
}

Configuration Configuration::from_text(std::string_view toml, std::string origin) {
  Configuration configuration;
  configuration.entries_ = configuration.published_ = read_entries(toml, origin);
  configuration.origin_ = std::move(origin);
  configuration.index_entries();
  return configuration;
}

void Configuration::index_entries() {
  positions_.clear();
  for (std::size_t i = 0; i < entries_.size(); ++i) positions_.emplace(entries_[i].key, i);
}

Configuration Configuration::overlaid(std::string_view toml, const std::string& origin) const {
  Configuration configuration = *this;
  overlay(configuration.entries_, read_entries(toml, origin));
  configuration.index_entries();
  return configuration;
}

const Entry* Configuration::find(std::string_view key) const {
  const auto found = positions_.find(key);
  return found == positions_.end() ? nullptr : &entries_[found->second];
}

const Entry& Configuration::require(std::string_view key, std::string_view wanted) const {
  known_.emplace(key);
  if (const Entry* entry = find(key)) return *entry;
  std::string hint;
  std::vector<std::string> unread;
  for (const Entry& entry : entries_)
    if (!is_known(entry.key)) unread.push_back(entry.key);
  const std::string similar = nearest(key, unread);
  if (!similar.empty() && edit_distance(key, similar) <= 3)
    hint = fmt::format(" (is \"{}\" at {} a misspelling of it?)", similar, find(similar)->key_place.text());
  const std::string table = users_table_of(key.substr(0, std::min(key.rfind('.'), key.size())));
  const std::string where =
      !table.empty() ? fmt::format("{}: [{}] lacks the key \"{}\"", find(table)->key_place.text(), table, key)
                     : fmt::format("{}: the key \"{}\" is missing", origin_, key);
  const std::string to = table.empty() && !users_file_.empty() ? "to " + users_file_ : "there";
  throw ConfigurationError(
      fmt::format("{}: {} is needed; add it {} or with --set {}=VALUE{}", where, wanted, to, key, hint));
}

bool Configuration::is_users(std::string_view key) const {
  return std::ranges::any_of(entries_, [&](const Entry& entry) {
    return entry.kind != Entry::Kind::table && !is_published_origin(entry) &&
           (entry.key == key || stands_below(entry.key, key));
  });
}

bool Configuration::is_users_table(std::string_view table) const {
  const Entry* entry = find(table);
  return entry != nullptr && entry->kind == Entry::Kind::table && !is_published_origin(*entry);
}

std::string Configuration::users_table_of(std::string_view table) const {
  while (!table.empty() && !is_users_table(table)) {
    const std::size_t dot = table.rfind('.');
    table = table.substr(0, dot == std::string_view::npos ? 0 : dot);
  }
  return std::string(table);
}

bool Configuration::is_of_base(std::string_view key) const {
  const Entry* entry = find(key);
  return entry != nullptr && !base_.empty() && entry->key_place.origin == base_;
}

bool Configuration::is_published_origin(const Entry& entry) const {
  return entry.key_place.origin == origin_ || (!base_.empty() && entry.key_place.origin == base_);
}

bool Configuration::has(std::string_view key) const {
  known_.emplace(key);
  return find(key) != nullptr;
}

void Configuration::accept(std::string_view key, std::string_view reason) const {
  std::string& known_reason = accepted_[std::string(key)];
  if (!reason.empty()) known_reason = reason;
}

void Configuration::describe_users(std::string_view pattern, std::string_view users) const {
  users_[std::string(pattern)] = users;
}

std::string Configuration::place_of(const std::vector<std::string>& tables) const {
  std::vector<std::string> places;
  for (const Entry& entry : entries_) {
    const auto covers = [&](const std::string& table) {
      return entry.key == table || stands_below(entry.key, table);
    };
    if (entry.kind == Entry::Kind::table || is_published_origin(entry) ||
        std::none_of(tables.begin(), tables.end(), covers))
      continue;
    places.push_back(entry.key_place.line == 0
                         ? entry.key_place.text()
                         : fmt::format("{}: {} = {}", entry.key_place.text(), entry.key, entry.whole.written));
  }
  if (!places.empty()) return fmt::format("{}", fmt::join(places, "; "));
  for (const std::string& table : tables)
    if (const Entry* entry = find(table)) return fmt::format("{}: [{}]", entry->key_place.text(), table);
  return origin_;
}

std::vector<std::string> Configuration::subtables(std::string_view key) const {
  known_.emplace(key);
  listed_.emplace(key);
  const Entry* parent = find(key);
  if (parent != nullptr && parent->kind == Entry::Kind::value)
    refuse_value(key, parent->whole, "is a value, but tables are needed", fmt::format("write [{}.NAME]", key));
  if (parent != nullptr && !parent->items.empty())
    refuse_value(key, parent->whole, "is a list of values, but tables are needed", fmt::format("write [[{}]]", key));
  std::vector<std::string> names;
  for (const Entry& entry : entries_) {
    if (!stands_below(entry.key, key)) continue;
    const std::string name = entry.key.substr(key.size() + 1);
    if (name.find('.') != std::string::npos) continue;
    if (entry.kind != Entry::Kind::table) {
      refuse_value(entry.key, entry.whole, fmt::format("is a value, but \"{}\" holds one table per name", key),
                   fmt::format("write {}.NAME.{}", key, name));
    }
    known_.insert(entry.key);
    names.push_back(name);
  }
  return names;
}

void Configuration::refuse(std::string_view key, std::string_view problem, std::string_view remedy) const {
  const Entry* entry = find(key);
  if (entry == nullptr) throw ConfigurationError(fmt::format("{}: {} {}; {}", origin_, key, problem, remedy));
  refuse_value(key, entry->whole, problem, remedy);
}

void Configuration::refuse_renamed(std::string_view key, std::string_view now) const {
  for (const std::vector<Entry>* entries : {&entries_, &unselected_})
    for (const Entry& entry : *entries)
      if (entry.key == key)
        throw ConfigurationError(
            fmt::format("{}: \"{}\" is called \"{}\" now; rename it", entry.key_place.text(), key, now));
}

bool Configuration::is_known(const std::string& key) const {
  if (known_.contains(key)) return true;
  for (const auto& [other, reason] : accepted_)
    if (other == key || stands_below(key, other) || stands_below(other, key)) return true;
  return std::any_of(known_.begin(), known_.end(), [&](const std::string& other) { return stands_below(other, key); });
}

std::string Configuration::with_wildcards(std::string_view key) const {
  std::string pattern(key);
  for (const std::string& table : listed_) {
    if (!stands_below(key, table)) continue;
    const std::size_t first = table.size() + 1;
    const std::size_t end = key.find('.', first);
    pattern = std::string(key.substr(0, first)) + '*';
    if (end != std::string_view::npos) pattern += key.substr(end);
    return pattern;
  }
  return pattern;
}

bool Configuration::is_known_elsewhere(const std::string& key) const {
  const std::string pattern = with_wildcards(key);
  const auto matches = [&](const std::string& other) {
    const std::string other_pattern = with_wildcards(other);
    return other_pattern == pattern || stands_below(other_pattern, pattern);
  };
  return pattern != key && (pattern.ends_with('*') || std::any_of(known_.begin(), known_.end(), matches));
}

std::string Configuration::unknown_message(const Entry& entry) const {
  const bool is_table = entry.kind == Entry::Kind::table;
  if (const std::string users = users_of(entry); !users.empty())
    return fmt::format("{}: the {} \"{}\" is known, but no run of this case uses it: it belongs to {}",
                       entry.key_place.text(), is_table ? "table" : "key", entry.key, users);
  std::set<std::string> keys(known_.begin(), known_.end());
  for (const auto& [key, reason] : accepted_) keys.insert(key);
  std::set<std::string> tables(listed_.begin(), listed_.end());
  for (const std::string& key : keys)
    for (std::size_t dot = key.find('.'); dot != std::string::npos; dot = key.find('.', dot + 1))
      tables.insert(key.substr(0, dot));
  for (const std::string& key : known_)
    if (const Entry* found = find(key); found != nullptr && found->kind == Entry::Kind::table) tables.insert(key);
  for (const std::string& table : tables) keys.erase(table);
  const std::set<std::string>& those = is_table && !tables.empty() ? tables : keys;
  const std::vector<std::string> candidates(those.begin(), those.end());
  std::string meant = is_table ? "" : key_meant(entry.key, candidates);
  const auto in_table = [&](const std::string& key) { return key.ends_with("." + entry.key); };
  if (const auto found = std::ranges::find_if(candidates, in_table);
      !is_table && meant.empty() && found != candidates.end())
    meant = *found;  // such as "angle" outside its table
  return fmt::format("{}: unknown {} \"{}\"; {}", entry.key_place.text(), is_table ? "table" : "key", entry.key,
                     !meant.empty()
                         ? fmt::format("did you mean \"{}\"?", meant)
                         : did_you_mean(entry.key, candidates, "no known name is similar; --dry-run prints all keys"));
}

/// The runs that use a key or a table which is not read in this case; empty if its name is not known.
std::string Configuration::users_of(const Entry& entry) const {
  const bool is_table = entry.kind == Entry::Kind::table;
  if (!is_table && is_known_elsewhere(entry.key)) {
    const std::size_t star = with_wildcards(entry.key).find('*');
    const std::string table = entry.key.substr(0, entry.key.find('.', star)), list = table.substr(0, star - 1);
    const auto is_read = [&](const std::string& key) { return stands_below(key, table); };
    if (std::none_of(known_.begin(), known_.end(), is_read))
      return fmt::format("[{}], which needs a run with {} = \"{}\"", table, list, table.substr(star));
  }
  for (const auto& [pattern, users] : users_)
    if (matches(entry.key, is_table ? beginning_like(pattern, entry.key) : pattern)) return users;
  return "";
}

/// Why a value of the user has no effect, as the end of a message; empty if a getter read the value. Unused values of
/// the case file and its base are allowed: they are defaults.
std::string Configuration::reason_for_no_effect(const Entry& entry) const {
  if (entry.kind == Entry::Kind::table || is_published_origin(entry) || resolved_.contains(entry.key)) return "";
  if (const auto nearer = overridden_.find(entry.key); nearer != overridden_.end())
    return fmt::format("every run that could use it has a nearer key, such as \"{}\"; set that key instead",
                       nearer->second);
  for (const auto& [key, reason] : accepted_)
    if (!reason.empty() && (key == entry.key || stands_below(entry.key, key))) return reason + "; remove it";
  return "";
}

void Configuration::reject_unknown() const {
  std::vector<std::string> messages;
  std::vector<std::string> tables;  // unknown tables: keys below them get no message of their own
  const auto check = [&](const Entry& entry) {
    if (!base_.empty() && entry.key_place.origin == base_) return;  // other cases read it
    const auto covers = [&](const std::string& table) { return stands_below(entry.key, table); };
    if (std::any_of(tables.begin(), tables.end(), covers)) return;
    if (entry.kind == Entry::Kind::table) tables.push_back(entry.key);
    messages.push_back(unknown_message(entry));
  };
  for (const Entry& entry : entries_)
    if (!is_known(entry.key)) check(entry);
    else if (const std::string reason = reason_for_no_effect(entry); !reason.empty())
      messages.push_back(fmt::format("{}: \"{}\" has no effect: {}", entry.key_place.text(), entry.key, reason));
  tables.clear();
  for (const Entry& entry : unselected_)
    if (!is_known(entry.key) && !is_known_elsewhere(entry.key)) check(entry);
  if (!messages.empty()) throw ConfigurationError(fmt::format("{}", fmt::join(messages, "\n")));
}

bool Configuration::is_published(std::string_view key) const {
  return std::any_of(published_.begin(), published_.end(), [&](const Entry& entry) { return entry.key == key; });
}

std::vector<Change> Configuration::changes() const {
  const auto same = [](const Entry& a, const Entry& b) {
    const auto equal = [](const Scalar& one, const Scalar& other) { return one.value == other.value; };
    return a.kind == b.kind && (a.kind == Entry::Kind::list
                                    ? std::equal(a.items.begin(), a.items.end(), b.items.begin(), b.items.end(), equal)
                                    : equal(a.whole, b.whole));
  };
  std::vector<Change> changes;
  for (const Entry& entry : entries_) {
    const auto value = resolved_.find(entry.key);
    if (value == resolved_.end()) continue;
    const auto before = std::find_if(published_.begin(), published_.end(),
                                     [&](const Entry& published) { return published.key == entry.key; });
    const auto* text = std::get_if<std::string>(&entry.whole.value);
    const bool is_text = entry.kind == Entry::Kind::value && text != nullptr;
    const std::string now = is_text ? canonical(std::string_view(*text)) : value->second;
    if (before == published_.end())
      changes.push_back({entry.key, now, ""});
    else if (!same(entry, *before))
      changes.push_back({entry.key, now, before->whole.written});
  }
  return changes;
}

Configuration::Lines Configuration::resolved_lines() const {
  Lines lines = resolved_;
  // A table that was asked for is shown as {} if none of its keys was read. Backwards: children before parents.
  for (auto key_at = known_.rbegin(); key_at != known_.rend(); ++key_at) {
    const std::string& key = *key_at;
    const Entry* entry = find(key);
    if (entry == nullptr || entry->kind != Entry::Kind::table) continue;
    const bool shown =
        std::any_of(lines.begin(), lines.end(), [&](const auto& line) { return stands_below(line.first, key); });
    if (!shown && !is_of_base(key)) lines[key] = "{}";
  }
  return lines;
}

std::string Configuration::resolved() const {
  std::string text;
  for (const auto& [key, value] : resolved_lines()) text += fmt::format("{} = {}\n", key, value);
  return text;
}

/// The source of a value: "fig12_pulse/case.toml:12", or the option.
std::string Configuration::origin_of(const std::string& key) const {
  const Place& place = find(key)->key_place;
  const std::filesystem::path file = place.origin;
  if (place.line == 0) return place.origin;
  return fmt::format("{}:{}", (file.parent_path().filename() / file.filename()).string(), place.line);
}

std::string Configuration::resolved_with_origins() const {
  std::string text;
  for (const auto& [key, value] : resolved_lines())
    text += fmt::format("{:<60} # {}\n", fmt::format("{} = {}", key, value), origin_of(key));
  return text;
}

std::string Configuration::inherited_with_origins(std::string_view list) const {
  std::string text;
  for (const auto& [key, source] : inherited_) {
    const auto value = resolved_.find(source);
    if (!stands_below(key, list) || value == resolved_.end()) continue;
    const std::string table = source.substr(0, source.find('.', list.size() + 1));
    text += fmt::format("{:<60} # like {}, {}\n", fmt::format("{} = {}", key, value->second), table, origin_of(source));
  }
  return text;
}

}  // namespace flowslide
