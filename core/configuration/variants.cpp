// SPDX-License-Identifier: GPL-2.0-or-later
// Copies of a configuration that differ in one value, for sweeps.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "configuration/canonical.hpp"
#include "configuration/configuration.hpp"
#include "configuration/error.hpp"
#include "configuration/value_check.hpp"

namespace flowslide {
namespace {

std::string text_of(const Scalar& scalar) {
  const auto* text = std::get_if<std::string>(&scalar.value);
  return text != nullptr ? *text : scalar.written;
}

/// Adds the elements of `from` to `to`. An element that is there already is kept.
template <typename Elements>
void add(Elements& to, const Elements& from) {
  to.insert(from.begin(), from.end());
}

}  // namespace

Configuration Configuration::with_item(const std::string& key, std::string_view list, std::size_t item) const {
  const Scalar value = require_items(list, "one value for each run").at(item);
  std::vector<Entry> layer;
  for (std::size_t dot = key.find('.'); dot != std::string::npos; dot = key.find('.', dot + 1)) {
    const std::string table = key.substr(0, dot);
    if (find(table) == nullptr)
      layer.push_back({.key = table, .kind = Entry::Kind::table, .key_place = {origin_}, .whole = {}, .items = {}});
  }
  layer.push_back({.key = key, .kind = Entry::Kind::value, .key_place = value.place, .whole = value, .items = {}});
  Configuration variant = *this;
  overlay(variant.entries_, layer);
  variant.index_entries();
  variant.resolved_.clear();
  return variant;
}

void Configuration::adopt(const Configuration& variant) const {
  add(known_, variant.known_);
  add(listed_, variant.listed_);
  add(users_, variant.users_);
  add(inherited_, variant.inherited_);
  add(overridden_, variant.overridden_);
  for (const auto& [key, reason] : variant.accepted_) accept(key, reason);
  for (const auto& [key, value] : variant.resolved_) {
    const Entry *own = find(key), *other = variant.find(key);
    if (own == nullptr || other == nullptr) continue;
    const Place &here = own->key_place, &there = other->key_place;
    if (here.text() == there.text()) resolved_.emplace(key, value);
  }
}

std::vector<std::string> Configuration::keys_below(std::string_view table) const {
  known_.emplace(table);
  if (const Entry* entry = find(table); entry != nullptr && entry->kind != Entry::Kind::table)
    refuse_value(table, entry->whole, "is a value, but a table is needed", fmt::format("write [{}]", table));
  std::vector<std::string> keys;
  for (const Entry& entry : entries_)
    if (stands_below(entry.key, table) && entry.kind != Entry::Kind::table)
      keys.push_back(entry.key.substr(table.size() + 1));
  return keys;
}

std::vector<std::string> Configuration::items_of(std::string_view key) const {
  std::vector<std::string> texts, lines;
  for (const Scalar& item : require_items(key, "one value for each run")) {
    if (std::holds_alternative<std::monostate>(item.value))
      refuse_value(key, item, "is no single value", "give a list of numbers or texts");
    texts.push_back(text_of(item));
    const bool is_text = std::holds_alternative<std::string>(item.value);
    lines.push_back(is_text ? canonical(std::string_view(texts.back())) : texts.back());
  }
  resolved_[std::string(key)] = fmt::format("[{}]", fmt::join(lines, ", "));
  return texts;
}

bool Configuration::is_list(std::string_view key) const {
  const Entry* entry = find(key);
  return entry != nullptr && entry->kind == Entry::Kind::list;
}

void Configuration::require_effect(std::string_view key) const {
  const Entry* entry = find(key);
  if (entry == nullptr || resolved_.contains(std::string(key))) return;
  const std::string reason = reason_for_no_effect(*entry);
  refuse_value(key, entry->whole, "has no effect: " + (reason.empty() ? "no run reads it" : reason),
               "sweep another key");
}

}  // namespace flowslide
