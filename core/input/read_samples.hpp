// SPDX-License-Identifier: GPL-2.0-or-later
// The parts of a configuration that all cases share, as the structures that they stand for.
#pragma once
#include <fmt/format.h>

#include "configuration/configuration.hpp"
#include "configuration/tables.hpp"
#include "sample/recipe.hpp"
#include "sample/void_ratio_search.hpp"
#include "slope/statics.hpp"

namespace flowslide {

/// Table [slope]: Table 2 and the angle.
SlopeProperties read_slope(const Configuration& configuration);

/// Table [material]: Table 1 and the rolling parameters that it leaves open.
Material read_material(const Configuration& configuration, const TableNames& tables = "material");

/// One sample that a case needs.
struct SampleSpecification {
  std::string name;          ///< its key below [sample]
  SampleRecipe recipe;       ///< where the search for its void ratio starts
  VoidRatioTarget target;
  bool allow_uneven = false;  ///< whether samples are taken that are not as even as a random packing (see unevenness)

  /// "e0_790_seed2": one for each sample of a configuration.
  std::string label() const { return fmt::format("{}_seed{}", name, recipe.packing.seed); }
};

/// The tables [sample.<name>], made of [material] as [packing] and [preparation] say, to the stresses of the slope;
/// tables of these names within a sample stand in front of them, key by key. `isotropic` samples bear no shear stress;
/// those with `periodic_height`, false where it is not said, have no glued layers (see SampleRecipe). `replicate` (from
/// 0) shifts the seed. What a search has found before spares the next one its trials: a sample may have a list
/// `seed_offsets` with the shift of each replicate, and a list `found_preparation_frictions` with its mu_1. Throws
/// ConfigurationError.
std::vector<SampleSpecification> read_samples(const Configuration& configuration, const SlopeProperties& slope,
                                              int replicate);

/// Refuses the value of `key` (s) as a DEM time step unless it suits grains of that diameter (m) and material.
void check_time_step(const Configuration& configuration, const std::string& key, double smallest_diameter,
                     const Material& material);

}  // namespace flowslide
