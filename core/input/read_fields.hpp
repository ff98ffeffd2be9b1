// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <array>
#include <initializer_list>
#include <string_view>

#include "configuration/tables.hpp"
#include "sample/recipe.hpp"

namespace flowslide {

/// The key of a member of a structure (see Field), with its unit and its bounds in SI units.
struct FieldKey {
  const char* name;
  const char* unit;
  Bounds bounds;

  template <typename Owner, typename Value>
  FieldKey(const Field<Owner, Value>& field) : name(field.name), unit(field.unit), bounds(field.bounds) {}

  Dimension dimension() const;
  Range range() const { return {bounds.lowest, bounds.highest, bounds.lowest_allowed, bounds.highest_allowed}; }
};

/// Each reads the value of `key`. Each throws ConfigurationError as the getters of Configuration.
void read_value(const Tables& tables, const FieldKey& key, double& value);
void read_value(const Tables& tables, const FieldKey& key, int& value);
void read_value(const Tables& tables, const FieldKey& key, std::int64_t& value);
void read_value(const Tables& tables, const FieldKey& key, bool& value);
void read_value(const Tables& tables, const FieldKey& key, ContactLaw& value);
void read_value(const Tables& tables, const FieldKey& key, std::array<double, 3>& values);
void read_value(const Tables& tables, const FieldKey& key, std::array<int, 3>& values);

template <Choice Enum>
void read_value(const Tables& tables, const FieldKey& key, Enum& value) {
  value = choice_of<Enum>(tables.text(key.name, choice_names<Enum>()));
}

/// Throws std::logic_error unless `fields` contains each of `names`.
void require_names(std::initializer_list<const char*> names, std::initializer_list<const char*> fields);

/// Reads every field of `owner` from the key of its name in `tables`, except the fields named in `elsewhere`. A field
/// that is added to the structure is therefore read without a change here.
template <HasFields Owner>
void read_fields(const Tables& tables, Owner& owner, std::initializer_list<const char*> elsewhere = {}) {
  std::apply([&](const auto&... field) { require_names(elsewhere, {field.name...}); }, Owner::fields());
  for_each_field(owner, [&]<typename Value>(const auto& field, Value& value) {
    for (const std::string_view name : elsewhere)
      if (name == field.name) return;
    if constexpr (requires { read_value(tables, field, value); })
      read_value(tables, field, value);
    else
      throw std::logic_error(std::string(field.name) + " is of a type that no configuration holds");
  });
}

/// The key of the field that describes `member`.
template <HasFields Owner, typename Value>
FieldKey key_of(Value Owner::*member) {
  return std::apply(
      [&](const auto&... field) {
        const FieldKey* found = nullptr;
        const std::array<FieldKey, sizeof...(field)> keys{FieldKey(field)...};
        std::size_t place = 0;
        ((found = detail::same_member(field.member, member) ? &keys[place] : found, ++place), ...);
        return *found;
      },
      Owner::fields());
}

/// Reads one field from `tables`.
template <HasFields Owner, typename Value>
void read_field(const Tables& tables, Owner& owner, Value Owner::*member) {
  read_value(tables, key_of(member), owner.*member);
}

}  // namespace flowslide
