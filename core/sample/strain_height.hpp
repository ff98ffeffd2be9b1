// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "grains/choice.hpp"

namespace flowslide {

/// The height that the displacement of the top plane is divided by to give the strain of a sample. The paper does not
/// say which.
enum class StrainHeight {
  cell,           ///< H, between the planes: tau times the shear rate times the volume is then the power of the top
  between_layers  ///< H minus the thickness of the glued layers (see layer_thickness), as in the decks of the first
                  ///< author: the grains between the layers have the strain of the slope in the mean
};

template <>
struct ChoiceNames<StrainHeight> {
  static constexpr const char* what = "the height of the strain";
  static constexpr std::array names{"cell", "between layers"};
};

}  // namespace flowslide
