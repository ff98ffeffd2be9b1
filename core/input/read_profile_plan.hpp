// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <string>

#include "configuration/configuration.hpp"
#include "experiment/profile_record.hpp"

namespace flowslide {

/// The list `strains_key`, and with it [profiles]: sublayers, snapshots, window. Without the list, no profiles. Throws
/// ConfigurationError.
ProfilePlan read_profile_plan(const Configuration& configuration, const std::string& strains_key);

}  // namespace flowslide
