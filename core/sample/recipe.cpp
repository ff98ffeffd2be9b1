// SPDX-License-Identifier: GPL-2.0-or-later
#include "sample/recipe.hpp"

#include <cmath>
#include <stdexcept>

#include "sample/health.hpp"
#include "sample/mixing.hpp"

namespace flowslide {

std::string SampleRecipe::text() const { return text_of_fields(*this); }

void validate(const SampleRecipe& recipe) {
  validate_fields(recipe);
  validate(recipe.packing);
  const double limit = recipe.material.sliding_friction * recipe.normal_stress;
  if (recipe.shear_stress != 0.0 && !(std::abs(recipe.shear_stress) < limit))
    throw std::invalid_argument(
        "shear_stress = " + field_text(recipe.shear_stress) +
        " Pa of the sample recipe is not possible: it must be 0, or smaller than sliding_friction times "
        "normal_stress, " +
        field_text(limit) + " Pa; no packing bears more");
  validate_time_step(recipe.time_step, 0.5 * recipe.packing.smallest_diameter, recipe.material);
  validate_impacts(recipe);
}

}  // namespace flowslide
