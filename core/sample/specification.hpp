// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <fmt/format.h>

#include <string>

#include "sample/recipe.hpp"
#include "sample/strain_height.hpp"
#include "sample/void_ratio_search.hpp"

namespace flowslide {

/// One sample that a case needs.
struct SampleSpecification {
  std::string name;          ///< key of its table below [sample]
  SampleRecipe recipe;       ///< first recipe of the search for its void ratio
  VoidRatioTarget target;
  bool allow_uneven = false;  ///< accepts samples that are less uniform than a random packing (see unevenness)
  StrainHeight strain_height = StrainHeight::cell;

  /// "e0_790_seed2": unique among the samples of a configuration.
  std::string label() const { return fmt::format("{}_seed{}", name, recipe.packing.seed); }
};

}  // namespace flowslide
