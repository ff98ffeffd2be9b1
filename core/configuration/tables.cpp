// SPDX-License-Identifier: GPL-2.0-or-later
#include "configuration/tables.hpp"

#include <algorithm>

namespace flowslide {

std::string Tables::key(const char* name) const {
  // Asks every table, which marks the key as known in each. An overridden key is not a misspelled one.
  std::string found;
  for (const std::string& table : tables_.names()) {
    const std::string candidate = table + "." + name;
    if (!configuration_.has(candidate)) continue;
    if (found.empty()) found = candidate;
    else configuration_.override_by(candidate, found);
  }
  const std::string& own = tables_.names().front();
  const std::string list = own.substr(0, own.find('.'));
  if (!found.empty() && !stands_below(found, own) && stands_below(found, list))
    configuration_.inherit(own + "." + name, found);
  return found.empty() ? table_to_complete() + "." + name : found;
}

const std::string& Tables::table_to_complete() const {
  const auto is_users = [&](const std::string& table) { return configuration_.is_users_table(table); };
  const auto is_below_users = [&](const std::string& table) { return !configuration_.users_table_of(table).empty(); };
  const std::vector<std::string>& names = tables_.names();
  auto own = std::find_if(names.begin(), names.end(), is_users);
  if (own == names.end()) own = std::find_if(names.begin(), names.end(), is_below_users);
  return own != names.end() ? *own : names.back();
}

void Tables::accept(std::initializer_list<const char*> names, const std::string& reason) const {
  for (const std::string& table : tables_.names())
    for (const char* name : names) configuration_.accept(table + "." + name, reason);
}

std::vector<std::string> with_like(const Configuration& configuration, const std::string& list,
                                   const std::string& name) {
  std::vector<std::string> tables{list + "." + name};
  for (std::string key = tables.front() + ".like"; configuration.has(key); key = tables.back() + ".like") {
    const std::string next = list + "." + configuration.text(key, configuration.subtables(list));
    if (std::find(tables.begin(), tables.end(), next) != tables.end())
      configuration.refuse(key, "closes a loop of tables, each like the next", "name a table without `like`");
    tables.push_back(next);
  }
  return tables;
}

TableNames within(std::vector<std::string> tables, const std::string& name, const std::vector<std::string>& others) {
  for (std::string& table : tables) table += "." + name;
  tables.insert(tables.end(), others.begin(), others.end());
  return tables;
}

}  // namespace flowslide
