// SPDX-License-Identifier: GPL-2.0-or-later
#include "program/changed_settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace flowslide {
namespace {

constexpr std::array harmless_names{
    "engine",      "seed",           "replicates",      "seed_offsets",  "found_preparation_frictions",
    "most_trials", "rows",           "most_rows",       "row_interval",  "row_strain",
    "figures",     "picture_strain", "local_time_step", "allow_unstable"};
constexpr std::array lists_of_tables{"point", "sample", "scheme", "axis"};

bool is_harmless(std::string_view key) {
  const std::size_t dot = key.rfind('.');
  const std::string_view name = dot == std::string_view::npos ? key : key.substr(dot + 1);
  return std::find(harmless_names.begin(), harmless_names.end(), name) != harmless_names.end() ||
         key == "preparation.time_step";
}

/// Whether a key belongs to a table of these lists that the case does not have, such as [point.mine].
bool is_added(const Configuration& configuration, std::string_view key) {
  for (const char* list : lists_of_tables) {
    if (!stands_below(key, list)) continue;
    const std::size_t name = std::string_view(list).size() + 1, end = key.find('.', name);
    return end != std::string_view::npos && !configuration.is_published(key.substr(0, end));
  }
  return false;
}

}  // namespace

std::vector<std::string> changed_settings(const Configuration& configuration) {
  std::vector<std::string> changed;
  for (const Change& change : configuration.changes())
    if (!is_harmless(change.key) && !is_added(configuration, change.key))
      changed.push_back(fmt::format("{} = {}, {}", change.key, change.value,
                                    change.before.empty() ? "which the case does not set" : "not " + change.before));
  return changed;
}

}  // namespace flowslide
