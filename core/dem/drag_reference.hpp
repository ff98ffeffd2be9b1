// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <string>
#include <vector>

namespace flowslide {

/// The velocity u in the drag force -c (v - u) on a grain.
enum class DragReference {
  rest,                ///< u = 0: drag holds every grain in place until a wall reaches it
  uniform_compression  ///< u(x) is the affine velocity field of the moving boundaries at the grain, see UniformFlow
};

/// "rest" or "uniform compression".
std::string name_of(DragReference reference);

/// All names.
std::vector<std::string> drag_reference_names();

/// The reference with this name. Throws std::invalid_argument for another name; the message gives the allowed names.
DragReference drag_reference_of(const std::string& name);

}  // namespace flowslide
