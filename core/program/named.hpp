// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

namespace flowslide {

/// The first element of `all` whose name is `name`. `name_of` is the member or function that gives the name. Throws
/// std::out_of_range if there is none; the message names `kind`, such as "point".
template <typename Element, typename NameOf>
const Element& named(const std::vector<Element>& all, const char* kind, const std::string& name, NameOf name_of) {
  const auto found = std::ranges::find(all, name, name_of);
  if (found == all.end()) throw std::out_of_range(fmt::format("there is no {} \"{}\"", kind, name));
  return *found;
}

}  // namespace flowslide
