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
  return found.empty() ? table_to_mend() + "." + name : found;
}

const std::string& Tables::table_to_mend() const {
  const auto is_users = [&](const std::string& table) { return configuration_.is_users_table(table); };
  const auto own = std::find_if(tables_.names().begin(), tables_.names().end(), is_users);
  return own != tables_.names().end() ? *own : tables_.names().back();
}

void Tables::accept(std::initializer_list<const char*> names) const {
  for (const std::string& table : tables_.names())
    for (const char* name : names) configuration_.accept(table + "." + name);
}

}  // namespace flowslide
