// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "configuration/configuration.hpp"
#include "configuration/tables.hpp"
#include "experiment/shear_test.hpp"
#include "sample/recipe.hpp"

namespace flowslide {

/// shear_rate, or inertial_number at the initial normal stress of the recipe; final_strain, rows. Throws
/// ConfigurationError, also if both or neither of the first two are given.
ElementTest read_element_test(const Configuration& configuration, const TableNames& tables, const SampleRecipe& recipe);

/// The test of a sample of that recipe with grains of that mean diameter (m): an inertial number stays, and the shear
/// rate follows from it. What is read has the packing that the search for the sample begins with.
ElementTest for_sample(ElementTest test, const SampleRecipe& recipe, double mean_diameter);

}  // namespace flowslide
