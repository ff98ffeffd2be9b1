// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

namespace flowslide {

/// The element of `all` that `name_of`, a member or a function, gives this name. Throws std::out_of_range with `kind`
/// ("point", say) and the name if there is none.
template <typename Element, typename NameOf>
const Element& named(const std::vector<Element>& all, const char* kind, const std::string& name, NameOf name_of) {
  const auto found = std::ranges::find(all, name, name_of);
  if (found == all.end()) throw std::out_of_range(fmt::format("there is no {} \"{}\"", kind, name));
  return *found;
}

}  // namespace flowslide
