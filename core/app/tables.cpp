// SPDX-License-Identifier: GPL-2.0-or-later
#include "app/tables.hpp"

namespace flowslide {

std::string Tables::key(const char* name) const {
  // All are asked, so that each knows the key: one that a nearer table overrides is no misspelling.
  std::string found;
  for (const std::string& table : tables_.names()) {
    const std::string candidate = table + "." + name;
    if (!configuration_.has(candidate)) continue;
    if (found.empty()) found = candidate;
    else configuration_.override_by(candidate, found);
  }
  return found.empty() ? tables_.names().back() + "." + name : found;
}

void Tables::accept(std::initializer_list<const char*> names) const {
  for (const std::string& table : tables_.names())
    for (const char* name : names) configuration_.accept(table + "." + name);
}

}  // namespace flowslide
