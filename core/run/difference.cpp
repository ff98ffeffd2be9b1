// SPDX-License-Identifier: GPL-2.0-or-later
#include "run/difference.hpp"

#include <fmt/format.h>

#include <map>
#include <set>

namespace flowslide {
namespace {

/// Keys and values of the lines `key = value`.
std::map<std::string, std::string> values_of_lines(std::string_view text) {
  std::map<std::string, std::string> values;
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    const std::size_t equals = line.find(" = ");
    if (equals == std::string_view::npos) continue;
    values.emplace(line.substr(0, equals), line.substr(equals + 3));
  }
  return values;
}

}  // namespace

std::string difference_of(std::string_view there, std::string_view now, int most) {
  const auto before = values_of_lines(there), after = values_of_lines(now);
  std::set<std::string> keys;
  for (const auto* values : {&before, &after})
    for (const auto& [key, value] : *values) keys.insert(key);
  std::string text;
  int different = 0;
  for (const std::string& key : keys) {
    const auto old_value = before.find(key), new_value = after.find(key);
    if (old_value != before.end() && new_value != after.end() && old_value->second == new_value->second) continue;
    if (++different > most) continue;
    if (!text.empty()) text += "; ";
    if (new_value == after.end()) text += fmt::format("{} = {} is only there", key, old_value->second);
    else if (old_value == before.end()) text += fmt::format("{} = {} is new", key, new_value->second);
    else text += fmt::format("{} = {} there, {} now", key, old_value->second, new_value->second);
  }
  if (different > most) text += fmt::format("; and {} more", different - most);
  return text;
}

}  // namespace flowslide
