// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <string>

#include "configuration/configuration.hpp"
#include "experiment/profile_record.hpp"

namespace flowslide {

/// Reads the strains at which profiles are taken from the list `strains_key`; without this key there are no profiles.
/// With it, reads sublayers, snapshots, window and read from [profiles]. Throws ConfigurationError, also if the strains
/// do not increase, or if a profile would begin before the last snapshot of the one before.
ProfilePlan read_profile_plan(const Configuration& configuration, const std::string& strains_key);

}  // namespace flowslide
