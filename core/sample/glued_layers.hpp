// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "grains/assembly.hpp"
#include "grains/choice.hpp"

namespace flowslide {

/// Which grains are glued to the bottom plane and to the top plane (paper, sec. 2.2.1). The paper does not say.
enum class Glue {
  one_layer,   ///< grains whose gap to the plane is below a quarter of the mean diameter
  outer_share  ///< grains whose centre lies in the outer 5 % of the height, as in the decks of the first author
};

template <>
struct ChoiceNames<Glue> {
  static constexpr const char* what = "the rule of the glued layers";
  static constexpr std::array names{"one layer", "outer share"};
};

/// Glues the grains at the bottom and at the top. They are set at rest. Contact histories between two grains of one
/// layer are removed. Throws NumericalFailure if a layer is empty or if a grain would belong to both.
void glue_layers(Assembly& assembly, Glue glue);

/// Distances (m) from a plane to the innermost centre of the grains that are glued to it.
struct LayerThickness {
  double bottom = 0.0, top = 0.0;
};

/// The thickness of the glued layers; 0 for a layer without grains.
LayerThickness layer_thickness(const Assembly& assembly);

}  // namespace flowslide
