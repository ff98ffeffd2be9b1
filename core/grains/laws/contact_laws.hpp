// SPDX-License-Identifier: GPL-2.0-or-later
//
// The contact laws that `material.contact_law` selects. Register a part or a law in the two lists below; its parameters
// then are keys of the configuration, and every engine knows it (docs/extending.md).
#pragma once
#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <vector>

#include "grains/laws/epsd3.hpp"
#include "grains/laws/hertz.hpp"
#include "grains/laws/linear.hpp"
#include "grains/laws/sliding.hpp"

namespace flowslide {
namespace laws {

/// A text as an argument of a template.
template <std::size_t size>
struct Text {
  char characters[size] = {};
  consteval Text(const char (&text)[size]) { std::copy_n(text, size, characters); }
};

/// A contact law of three parts. `law_name` is its value of `material.contact_law`.
template <Text law_name, typename NormalPart, typename TangentialPart, typename RollingPart>
struct Law {
  static constexpr const char* name = law_name.characters;
  using Normal = NormalPart;
  using Tangential = TangentialPart;
  using Rolling = RollingPart;
};

using Parts = List<Hertz, Linear, Sliding, Epsd3>;
using Laws = List<Law<"hertz", Hertz, Sliding, Epsd3>, Law<"linear", Linear, Sliding, Epsd3>>;

/// Calls visit(Law) for the law number `index` of the list and returns its result.
template <typename First, typename... Rest, typename Visit>
constexpr decltype(auto) visit_item(List<First, Rest...>, int index, Visit&& visit) {
  if constexpr (sizeof...(Rest) > 0)
    if (index > 0) return visit_item(List<Rest...>{}, index - 1, visit);
  return visit(First{});
}

template <typename... Items, typename Visit>
constexpr void for_each_item(List<Items...>, Visit&& visit) {
  (visit(Items{}), ...);
}

/// The items of both lists in their order, each once.
template <typename Items, typename More>
struct Union;
template <typename... Items>
struct Union<List<Items...>, List<>> {
  using Type = List<Items...>;
};
template <typename... Items, typename First, typename... Rest>
struct Union<List<Items...>, List<First, Rest...>>
    : Union<std::conditional_t<(std::is_same_v<Items, First> || ...), List<Items...>, List<Items..., First>>,
            List<Rest...>> {};

/// The structs of parameters of all parts, each once: parts may share one.
template <typename Parts, typename Found = List<>>
struct ParametersOfParts {
  using Type = Found;
};
template <typename First, typename... Rest, typename Found>
struct ParametersOfParts<List<First, Rest...>, Found>
    : ParametersOfParts<List<Rest...>, typename Union<Found, typename First::Parameters>::Type> {};

/// These structs as one.
template <typename Items>
struct Joined;
template <typename... Items>
struct Joined<List<Items...>> : Items... {
  bool operator==(const Joined&) const = default;
  static constexpr auto fields() { return std::tuple_cat(Items::fields()...); }
};

/// The parameters of all parts, as one base of Material.
template <typename Parts>
using ParametersOf = Joined<typename ParametersOfParts<Parts>::Type>;

/// Whether a part has a parameter of this name.
template <typename Part>
constexpr bool has_parameter(std::string_view name) {
  return std::apply([&](const auto&... field) { return ((name == field.name) || ...); },
                    Joined<typename Part::Parameters>::fields());
}

template <typename... Items>
consteval bool have_different_names(List<Items...>) {
  const auto occurrences = [](std::string_view name) { return (0 + ... + (name == Items::name)); };
  return ((occurrences(Items::name) == 1) && ...);
}
static_assert(have_different_names(Laws{}), "two laws of the list have the same name");

template <typename Part, typename... Items>
consteval bool contains(List<Items...>) {
  return (std::is_same_v<Part, Items> || ...);
}
template <typename... Items>
consteval bool have_listed_parts(List<Items...>) {
  return ((contains<typename Items::Normal>(Parts{}) && contains<typename Items::Tangential>(Parts{}) &&
           contains<typename Items::Rolling>(Parts{})) && ...);
}
static_assert(have_listed_parts(Laws{}), "add each part of a law to Parts");

/// The engines leave out the tangential part of a material without sliding friction, and likewise the rolling part.
template <typename... Items>
consteval bool are_left_out_without_friction(List<Items...>) {
  return ((has_parameter<typename Items::Tangential>("sliding_friction") &&
           has_parameter<typename Items::Rolling>("rolling_friction")) && ...);
}
static_assert(are_left_out_without_friction(Laws{}),
              "a tangential part has the parameter sliding_friction, and a rolling part rolling_friction");

}  // namespace laws

/// A law of the list. The default is the first, "hertz".
enum class ContactLaw : int { hertz = 0 };

/// Calls visit(laws::Law<...>{}) for this law and returns its result.
template <typename Visit>
constexpr decltype(auto) visit_law(ContactLaw law, Visit&& visit) {
  return laws::visit_item(laws::Laws{}, static_cast<int>(law), visit);
}

/// The name in a configuration and in results.
std::string name_of(ContactLaw law);

/// All names, in the order of the list.
std::vector<std::string> contact_law_names();

/// The law with this name. Throws std::invalid_argument for another name; the message gives the allowed names.
ContactLaw contact_law_of(const std::string& name);

/// Whether a law reads the parameter `name` of the parts. True for a name that no part has.
bool uses_parameter(ContactLaw law, std::string_view name);

inline std::string field_text(ContactLaw law) { return name_of(law); }

}  // namespace flowslide
