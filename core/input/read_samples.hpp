// SPDX-License-Identifier: GPL-2.0-or-later
// The parts of a configuration that all cases share, as the structures that they stand for.
#pragma once

#include <string>
#include <vector>

#include "configuration/configuration.hpp"
#include "configuration/tables.hpp"
#include "sample/specification.hpp"
#include "slope/statics.hpp"

namespace flowslide {

/// Table [slope]: Table 2 and the angle.
SlopeProperties read_slope(const Configuration& configuration);

/// Table [material]: Table 1 and the rolling parameters that it leaves open.
Material read_material(const Configuration& configuration, const TableNames& tables = "material");

/// Names of the tables [sample.<name>] that are read. Those that stand in the base of the case file alone are read if
/// a point names them: several cases share the base.
std::vector<std::string> samples_in_use(const Configuration& configuration);

/// The samples in use, made of [material] as [packing] and [preparation] say, to the stresses of the slope;
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
