// SPDX-License-Identifier: GPL-2.0-or-later
// A list of the members of a structure of parameters. Text, validation, reader and test of the structure all use this
// list, so that no member can be forgotten.
#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <tuple>
#include <type_traits>

#include "grains/choice.hpp"

namespace flowslide {

/// The allowed values of a number, in SI units. NaN and infinity are never allowed.
struct Bounds {
  double lowest = -std::numeric_limits<double>::infinity();
  double highest = std::numeric_limits<double>::infinity();
  bool lowest_allowed = true;   ///< false: the lowest value itself is excluded
  bool highest_allowed = true;  ///< false: the highest value itself is excluded

  static constexpr Bounds any() { return {}; }
  static constexpr Bounds at_least(double low) { return {.lowest = low}; }
  static constexpr Bounds positive() { return {.lowest = 0.0, .lowest_allowed = false}; }
  static constexpr Bounds not_negative() { return at_least(0.0); }
  /// [low, high]
  static constexpr Bounds between(double low, double high) { return {.lowest = low, .highest = high}; }
  /// (low, high)
  static constexpr Bounds inside(double low, double high) { return {low, high, false, false}; }
  /// [low, high)
  static constexpr Bounds from_below(double low, double high) { return {low, high, true, false}; }
  /// (low, high]
  static constexpr Bounds above_up_to(double low, double high) { return {low, high, false, true}; }

  bool contain(double value) const;
  /// The bounds as text: "above 0 and at most 1", "at least 0", "any finite number".
  std::string describe() const;
};

/// Whether a value changes the result, or only limits the cost of a computation.
enum class Effect { on_result, limit_only };

/// One member of `Owner`. The type of the member is a number, a flag, an enumeration, an array of numbers, or a
/// structure that lists its own fields.
template <typename Owner, typename Value>
struct Field {
  constexpr Field(const char* the_name, Value Owner::*the_member, const char* the_unit = "1",
                  Bounds the_bounds = Bounds::any(), Effect the_effect = Effect::on_result)
      : name(the_name), member(the_member), unit(the_unit), bounds(the_bounds), effect(the_effect) {}

  const char* name;  ///< name in texts and messages; also the key in a configuration
  Value Owner::*member;
  const char* unit;  ///< SI; "1" for a number without dimension
  Bounds bounds;     ///< bounds of the number or of each element of an array
  Effect effect;
};

/// A structure with `static constexpr auto fields()`, which returns a std::tuple with one Field per member.
template <typename T>
concept HasFields = requires {
  std::remove_const_t<T>::fields();
};

/// Calls `visit(field, member)` for each member of `owner`, in the order of the list. An owner with a member function
/// `bool uses(const char* name) const` leaves out the fields for which it is false at their turn.
template <HasFields Owner, typename Visit>
void for_each_field(Owner& owner, Visit&& visit) {
  const auto visit_one = [&](const auto& field) {
    if constexpr (requires { owner.uses(field.name); })
      if (!owner.uses(field.name)) return;
    visit(field, owner.*field.member);
  };
  std::apply([&](const auto&... field) { (visit_one(field), ...); }, std::remove_const_t<Owner>::fields());
}

/// The same, but replaces a nested structure by its fields: `visit(name, field, member)` with names such as
/// "material.density".
template <HasFields Owner, typename Visit>
void for_each_leaf(Owner& owner, Visit&& visit, const std::string& prefix = "") {
  for_each_field(owner, [&]<typename F, typename Value>(const F& field, Value& value) {
    if constexpr (HasFields<Value>)
      for_each_leaf(value, visit, prefix + field.name + ".");
    else
      visit(prefix + field.name, field, value);
  });
}

/// The shortest text that restores the same number; "true" or "false" for a flag; the name of a choice, or else the
/// number of an enumerator.
std::string field_text(double value);
std::string field_text(std::int64_t value);
std::string field_text(std::uint64_t value);
std::string field_text(bool value);
inline std::string field_text(int value) { return field_text(std::int64_t{value}); }
template <typename Enum>
requires std::is_enum_v<Enum> std::string field_text(Enum value) {
  if constexpr (Choice<Enum>)
    return name_of(value);
  else
    return field_text(static_cast<std::int64_t>(value));
}
/// The elements, separated by blanks.
template <typename T, std::size_t size>
std::string field_text(const std::array<T, size>& values) {
  std::string text;
  for (const T& value : values) text.append(text.empty() ? "" : " ").append(field_text(value));
  return text;
}

/// A line "name = value" for each field with an effect on results. Two owners have equal texts exactly if they give the
/// same result.
template <HasFields Owner>
std::string text_of_fields(const Owner& owner) {
  std::string text;
  for_each_leaf(owner, [&](const std::string& name, const auto& field, const auto& value) {
    if (field.effect == Effect::on_result) text += name + " = " + field_text(value) + "\n";
  });
  return text;
}

/// Throws std::invalid_argument unless the bounds contain the value. The message gives name, value and allowed range.
void require_within(const Bounds& bounds, const std::string& name, double value, const std::string& unit);

/// Throws std::invalid_argument for the first number of `owner` that is out of its bounds.
template <HasFields Owner>
void validate_fields(const Owner& owner) {
  for_each_leaf(owner, []<typename F, typename Value>(const std::string& name, const F& field, const Value& value) {
    if constexpr (std::is_arithmetic_v<Value>)
      require_within(field.bounds, name, static_cast<double>(value), field.unit);
    else if constexpr (!std::is_enum_v<Value>)
      for (const auto& element : value) require_within(field.bounds, name, static_cast<double>(element), field.unit);
  });
}

namespace detail {

struct Anything {
  template <typename T>
  constexpr operator T() const;
};

template <typename T, typename... Members>
consteval std::size_t count_members() {
  if constexpr (requires { T{Members{}..., Anything{}}; })
    return count_members<T, Members..., Anything>();
  else
    return sizeof...(Members);
}

template <typename A, typename B>
constexpr bool same_member(A a, B b) {
  if constexpr (std::is_same_v<A, B>)
    return a == b;
  else
    return false;
}

}  // namespace detail

/// Whether the list of the aggregate `Owner` names each of its members once. Use it in a static_assert below the
/// structure: a new member that is missing in the list then stops the build.
template <HasFields Owner>
consteval bool lists_every_member() {
  return std::apply(
      [](const auto&... field) {
        const auto occurrences = [&](auto member) { return (0 + ... + detail::same_member(member, field.member)); };
        return sizeof...(field) == detail::count_members<Owner>() && ((occurrences(field.member) == 1) && ...);
      },
      Owner::fields());
}

}  // namespace flowslide
