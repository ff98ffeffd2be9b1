// SPDX-License-Identifier: GPL-2.0-or-later
#include "grains/laws/contact_laws.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

namespace flowslide {

std::string name_of(ContactLaw law) {
  return visit_law(law, []<typename Law>(Law) { return std::string(Law::name); });
}

std::vector<std::string> contact_law_names() {
  std::vector<std::string> names;
  laws::for_each_item(laws::Laws{}, [&]<typename Law>(Law) { names.emplace_back(Law::name); });
  return names;
}

ContactLaw contact_law_of(const std::string& name) {
  const std::vector<std::string> names = contact_law_names();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    throw std::invalid_argument(
        fmt::format("the contact law \"{}\" is not known; choose one of: {}", name, fmt::join(names, ", ")));
  return static_cast<ContactLaw>(found - names.begin());
}

bool uses_parameter(ContactLaw law, std::string_view name) {
  bool of_a_part = false;
  laws::for_each_item(laws::Parts{}, [&]<typename Part>(Part) { of_a_part |= laws::has_parameter<Part>(name); });
  if (!of_a_part) return true;
  return visit_law(law, [&]<typename Law>(Law) {
    return laws::has_parameter<typename Law::Normal>(name) || laws::has_parameter<typename Law::Tangential>(name) ||
           laws::has_parameter<typename Law::Rolling>(name);
  });
}

}  // namespace flowslide
