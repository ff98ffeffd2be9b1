// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <string>
#include <vector>

namespace flowslide {

/// The velocity that the drag on a grain is measured from.
enum class DragReference {
  rest,                ///< none: -c v. Drag then holds every grain in its place until a wall reaches it.
  uniform_compression  ///< that of the affine field of the moving boundaries at the grain: -c (v - u(x)), see
                       ///< UniformFlow
};

/// "rest" or "uniform compression".
std::string name_of(DragReference reference);

/// All of these names.
std::vector<std::string> drag_reference_names();

/// The reference of that name. Throws std::invalid_argument, with the names that are allowed, if there is none.
DragReference drag_reference_of(const std::string& name);

}  // namespace flowslide
