// SPDX-License-Identifier: GPL-2.0-or-later
#include "configuration/entry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>

#include "configuration/error.hpp"

namespace flowslide {
namespace {

std::optional<std::uint64_t> as_position(std::string_view part) {
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), number);
  if (error != std::errc{} || end != part.data() + part.size()) return std::nullopt;
  return number;
}

std::string_view take_part(std::string_view& key) {
  const std::size_t dot = key.find('.');
  const std::string_view part = key.substr(0, dot);
  key.remove_prefix(dot == std::string_view::npos ? key.size() : dot + 1);
  return part;
}

[[noreturn]] void refuse_change_of_kind(const Entry& before, const Entry& after) {
  if (before.kind == Entry::Kind::table) {
    throw ConfigurationError(fmt::format("{}: {} = {} would replace the table [{}] of {}; set one of its keys instead",
                                         after.whole.place.text(), after.key, after.whole.written, before.key,
                                         before.key_place.text()));
  }
  throw ConfigurationError(fmt::format("{}: the table [{}] would replace the value {} of {}; give a value instead",
                                       after.key_place.text(), after.key, before.whole.written,
                                       before.whole.place.text()));
}

}  // namespace

std::string Place::text() const { return line == 0 ? origin : fmt::format("{}:{}:{}", origin, line, column); }

bool KeyOrder::operator()(std::string_view a, std::string_view b) const {
  while (!a.empty() && !b.empty()) {
    const std::string_view part_a = take_part(a);
    const std::string_view part_b = take_part(b);
    if (part_a == part_b) continue;
    const auto position_a = as_position(part_a);
    const auto position_b = as_position(part_b);
    if (position_a && position_b && *position_a != *position_b) return *position_a < *position_b;
    if (position_a.has_value() != position_b.has_value()) return position_a.has_value();
    return part_a < part_b;
  }
  return a.empty() && !b.empty();
}

bool stands_below(std::string_view key, std::string_view table) {
  return key.size() > table.size() && key.starts_with(table) && key[table.size()] == '.';
}

void overlay(std::vector<Entry>& base, const std::vector<Entry>& layer) {
  for (const Entry& entry : layer) {
    const auto before =
        std::find_if(base.begin(), base.end(), [&](const Entry& other) { return other.key == entry.key; });
    if (before == base.end()) {
      base.push_back(entry);
      continue;
    }
    if (entry.list_of_tables) {
      take_below(base, entry.key);
      base.push_back(entry);
      continue;
    }
    if ((before->kind == Entry::Kind::table) != (entry.kind == Entry::Kind::table))
      refuse_change_of_kind(*before, entry);
    if (entry.kind != Entry::Kind::table) *before = entry;
  }
}

std::vector<Entry> take_below(std::vector<Entry>& entries, const std::string& prefix) {
  std::vector<Entry> taken;
  for (const Entry& entry : entries) {
    if (!stands_below(entry.key, prefix)) continue;
    taken.push_back(entry);
    taken.back().key.erase(0, prefix.size() + 1);
  }
  std::erase_if(entries, [&](const Entry& entry) { return entry.key == prefix || stands_below(entry.key, prefix); });
  return taken;
}

}  // namespace flowslide
