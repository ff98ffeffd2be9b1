// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "grains/choice.hpp"

namespace flowslide {

/// The velocity u in the drag force -c (v - u) on a grain.
enum class DragReference {
  rest,                ///< u = 0: drag holds every grain in place until a wall reaches it
  uniform_compression  ///< u(x) is the affine velocity field of the moving boundaries at the grain, see UniformFlow
};

template <>
struct ChoiceNames<DragReference> {
  static constexpr const char* what = "the drag reference";
  static constexpr std::array names{"rest", "uniform compression"};
};

}  // namespace flowslide
