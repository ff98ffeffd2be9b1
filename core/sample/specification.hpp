// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <fmt/format.h>

#include <string>

#include "sample/recipe.hpp"
#include "sample/void_ratio_search.hpp"

namespace flowslide {

/// One sample that a case needs.
struct SampleSpecification {
  std::string name;          ///< its key below [sample]
  SampleRecipe recipe;       ///< where the search for its void ratio starts
  VoidRatioTarget target;
  bool allow_uneven = false;  ///< whether samples are taken that are not as even as a random packing (see unevenness)

  /// "e0_790_seed2": one for each sample of a configuration.
  std::string label() const { return fmt::format("{}_seed{}", name, recipe.packing.seed); }
};

}  // namespace flowslide
