// SPDX-License-Identifier: GPL-2.0-or-later
// Reads slope, material and samples from a configuration.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "configuration/configuration.hpp"
#include "configuration/tables.hpp"
#include "sample/specification.hpp"
#include "slope/statics.hpp"

namespace flowslide {

/// Distance between the seeds of two replicates. It leaves room for the seeds that a search tries.
inline constexpr std::uint64_t seeds_per_replicate = 1000;

/// Reads the table [slope]: Table 2 of the paper and the angle. Throws ConfigurationError.
SlopeProperties read_slope(const Configuration& configuration);

/// Reads the table [material]: Table 1 of the paper and the rolling parameters, which Table 1 does not give. Throws
/// ConfigurationError.
Material read_material(const Configuration& configuration, const TableNames& tables = "material");

/// Names of the samples to read, from the tables [sample.<name>]. Several cases share one base, so a sample that only
/// the base defines is read only if a table [point.<name>] uses it.
std::vector<std::string> samples_in_use(const Configuration& configuration);

/// Reads the samples in use. Each is prepared as [material], [packing] and [preparation] say, to the initial stresses
/// of the slope. The keys of [sample.<name>]:
///   like                                another sample, from which missing keys are taken; optional
///   material, packing, preparation      tables whose keys win over the top-level tables of the same name; optional
///   void_ratio, tolerance, most_trials  the void ratio to find, and the limits of the search
///   preparation_friction, drag          mu_1 and the drag coefficient (kg/s) with which the search starts
///   void_ratio_of                       "cell" or "probe" (see VoidRatioRegion); optional, "cell"
///   glue                                "one layer" or "outer share" (see Glue); optional, "one layer"
///   strain_height                       "cell" or "between layers" (see StrainHeight); optional, "cell"
///   isotropic                           true: no initial shear stress
///   periodic_height                     true: no glued layers (see SampleRecipe); optional, false
///   seed_offsets                        shift of the seed for each replicate; optional
///   found_preparation_frictions         mu_1 for each replicate; optional; not taken from the sample it is `like`
/// The two lists hold the results of an earlier search and save the trials of the next. `replicate` (from 0) selects
/// their items. Without an item for it, the seed is shifted by 1000 `replicate` (see seeds_per_replicate). Throws
/// ConfigurationError.
std::vector<SampleSpecification> read_samples(const Configuration& configuration, const SlopeProperties& slope,
                                              int replicate);

/// Reads a time step of grains (s) from `key`. Refuses a value above the longest step for this smallest diameter (m)
/// and material, a fraction of the Rayleigh time (see longest_time_step).
double read_grain_time_step(const Configuration& configuration, const std::string& key, double smallest_diameter,
                            const Material& material);

}  // namespace flowslide
