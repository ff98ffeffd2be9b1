// SPDX-License-Identifier: GPL-2.0-or-later
#include "input/read_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace flowslide {
namespace {

template <typename Read, typename Value>
void take_three(const Tables& tables, const FieldKey& key, const std::vector<Read>& read,
                std::array<Value, 3>& values) {
  if (read.size() != values.size())
    tables.refuse(key.name, fmt::format("has {} values, but 3 are needed", read.size()), "give a list of three");
  std::transform(read.begin(), read.end(), values.begin(), [](Read value) { return static_cast<Value>(value); });
}

}  // namespace

Dimension FieldKey::dimension() const {
  return std::string_view(unit) == "1" ? dimension::dimensionless : parse_quantity(std::string("1 ") + unit).dimension;
}

void read_value(const Tables& tables, const FieldKey& key, double& value) {
  value = tables.quantity(key.name, key.dimension(), key.range());
}

void read_value(const Tables& tables, const FieldKey& key, int& value) {
  value = static_cast<int>(tables.integer(key.name, key.range()));
}

void read_value(const Tables& tables, const FieldKey& key, std::int64_t& value) {
  value = tables.integer(key.name, key.range());
}

void read_value(const Tables& tables, const FieldKey& key, bool& value) { value = tables.flag(key.name); }

void read_value(const Tables& tables, const FieldKey& key, ContactLaw& value) {
  value = contact_law_of(tables.text(key.name, contact_law_names()));
}

void read_value(const Tables& tables, const FieldKey& key, std::array<double, 3>& values) {
  take_three(tables, key, tables.quantities(key.name, key.dimension(), key.range()), values);
}

void read_value(const Tables& tables, const FieldKey& key, std::array<int, 3>& values) {
  take_three(tables, key, tables.integers(key.name, key.range()), values);
}

void require_names(std::initializer_list<const char*> names, std::initializer_list<const char*> fields) {
  for (const std::string_view name : names)
    if (std::none_of(fields.begin(), fields.end(), [&](std::string_view field) { return field == name; }))
      throw std::logic_error(fmt::format("there is no field \"{}\"", name));
}

}  // namespace flowslide
