// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <string>
#include <vector>

#include "configuration/configuration.hpp"

namespace flowslide {

/// The settings that differ from those of the case, one text for each:
///   loading.amplitude = 2000.0 Pa, not "3 kPa"
/// The claims of the paper assume the settings of the case. They are not evaluated if this list is not empty.
///
/// Left out is what decides how a run is computed, not what: the engines, the draw and the number of the samples (seed,
/// replicates, seed_offsets, found_preparation_frictions, most_trials), the rows that are kept, the time steps of the
/// grains (local_time_step, preparation.time_step) and allow_unstable. Left out, too, are the tables [point.<name>],
/// [sample.<name>], [scheme.<name>] and [axis.<name>] that a study adds, as no claim is about them.
std::vector<std::string> changed_settings(const Configuration& configuration);

}  // namespace flowslide
