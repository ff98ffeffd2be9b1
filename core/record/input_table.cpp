// SPDX-License-Identifier: GPL-2.0-or-later
#include "record/input_table.hpp"

#include <fmt/format.h>

#include "record/hash.hpp"

namespace flowslide {

std::string content_of(const InputTable& table) {
  std::string text;
  const auto add = [&](const Column& column) {
    text += fmt::format("{} in {}: {}\n", column.name, column.units, fmt::join(column.values, " "));
  };
  add(table.rows.axis);
  for (const Column& column : table.rows.columns) add(column);
  return fmt::format("{} rows (hash {})", table.rows.rows(), hash_of(text));
}

}  // namespace flowslide
