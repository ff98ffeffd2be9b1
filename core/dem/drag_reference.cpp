// SPDX-License-Identifier: GPL-2.0-or-later
#include "dem/drag_reference.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace flowslide {

std::string name_of(DragReference reference) {
  return reference == DragReference::rest ? "rest" : "uniform compression";
}

std::vector<std::string> drag_reference_names() {
  return {name_of(DragReference::rest), name_of(DragReference::uniform_compression)};
}

DragReference drag_reference_of(const std::string& name) {
  for (const DragReference reference : {DragReference::rest, DragReference::uniform_compression})
    if (name == name_of(reference)) return reference;
  throw std::invalid_argument(
      fmt::format("the drag reference \"{}\" is not known; allowed: \"rest\" and "
                  "\"uniform compression\"",
                  name));
}

}  // namespace flowslide
