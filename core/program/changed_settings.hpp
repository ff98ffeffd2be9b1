// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <string>
#include <vector>

#include "configuration/configuration.hpp"

namespace flowslide {

/// The settings that differ from those of the case, one text for each:
///   loading.amplitude = "2 kPa", not "3 kPa"
/// The claims of the paper assume the settings of the case. They are not evaluated if this list is not empty.
///
/// Two groups of settings are left out. First, those that change how a run is computed but not what it models: the
/// engines; seed, replicates, seed_offsets, found_preparation_frictions and most_trials of the samples; the rows kept;
/// figures and picture_strain; the DEM time steps (local_time_step, preparation.time_step); and allow_unstable. Second,
/// the tables [point.<name>], [sample.<name>], [scheme.<name>] and [axis.<name>] that the user adds, because no claim
/// is about them.
std::vector<std::string> changed_settings(const Configuration& configuration);

}  // namespace flowslide
