// SPDX-License-Identifier: GPL-2.0-or-later
// Reads slope, material and samples from a configuration.
#pragma once

#include <string>
#include <vector>

#include "configuration/configuration.hpp"
#include "configuration/tables.hpp"
#include "sample/specification.hpp"
#include "slope/statics.hpp"

namespace flowslide {

/// Reads the table [slope]: Table 2 of the paper and the angle. Throws ConfigurationError.
SlopeProperties read_slope(const Configuration& configuration);

/// Reads the table [material]: Table 1 of the paper and the rolling parameters, which Table 1 does not give. Throws
/// ConfigurationError.
Material read_material(const Configuration& configuration, const TableNames& tables = "material");

/// Names of the samples to read, from the tables [sample.<name>]. Several cases share one base, so a sample that only
/// the base defines is read only if a table [point.<name>] uses it.
std::vector<std::string> samples_in_use(const Configuration& configuration);

/// The samples in use: grains of [material], packed as [packing] and [preparation] say, to the stresses of the slope.
/// Keys of a sample:
/// - `like`: another sample, from which the keys that are missing are taken;
/// - tables `material`, `packing`, `preparation`, whose keys win over those of the tables of the same name at the top;
/// - `void_ratio`, `tolerance`, `most_trials`, `preparation_friction`, `drag`: what the search looks for, and where it
///   begins;
/// - `isotropic`: the sample bears no shear stress;
/// - `periodic_height`: the sample has no glued layers (see SampleRecipe); false without the key;
/// - `seed_offsets` and `found_preparation_frictions`: shift of the seed and mu_1 of each replicate, as an earlier search
///   found them, which saves its trials.
/// `replicate` counts from 0 and shifts the seed. Throws ConfigurationError.
std::vector<SampleSpecification> read_samples(const Configuration& configuration, const SlopeProperties& slope,
                                              int replicate);

/// Refuses the value of `key` (s) if it exceeds the longest DEM time step for this smallest diameter (m) and material,
/// a fraction of the Rayleigh time (see longest_time_step).
void check_time_step(const Configuration& configuration, const std::string& key, double smallest_diameter,
                     const Material& material);

}  // namespace flowslide
