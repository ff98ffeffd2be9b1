// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "grains/assembly.hpp"

namespace flowslide {

/// Glues one layer of grains to the bottom plane and one to the top plane (paper, sec. 2.2.1). A layer consists of the
/// grains whose gap to its plane is below `reach` (m). Glued grains are set at rest. Contact histories between two
/// grains of one layer are removed. Throws NumericalFailure if a layer is empty or if a grain would belong to both.
void glue_layers(Assembly& assembly, double reach);

}  // namespace flowslide
