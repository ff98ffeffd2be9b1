// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "grains/assembly.hpp"

namespace flowslide {

/// Glues one layer of grains to the bottom and one to the top plane (paper, sec. 2.2.1): every mobile grain whose gap
/// to a z plane is below `reach` (m). Glued grains stop moving and lose their histories with each other. Throws
/// NumericalFailure if a layer stays empty or a grain would belong to both.
void glue_layers(Assembly& assembly, double reach);

}  // namespace flowslide
