// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "configuration/configuration.hpp"
#include "configuration/tables.hpp"
#include "experiment/shear_test.hpp"
#include "sample/recipe.hpp"

namespace flowslide {

/// Reads an element test: final_strain, rows, end_normal_stress (optional), and either shear_rate or inertial_number.
/// The inertial number is that at the initial normal stress of the recipe. Throws ConfigurationError, also if both or
/// neither of the two are given.
ShearTest read_shear_test(const Configuration& configuration, const TableNames& tables, const SampleRecipe& recipe);

}  // namespace flowslide
