// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "app/configuration.hpp"
#include "app/element_test.hpp"
#include "app/tables.hpp"
#include "sample/recipe.hpp"

namespace flowslide {

/// shear_rate, or inertial_number at the initial normal stress of the recipe; final_strain, rows. Throws
/// ConfigurationError, also if both or neither of the first two are given.
ElementTest read_element_test(const Configuration& configuration, const TableNames& tables, const SampleRecipe& recipe);

}  // namespace flowslide
