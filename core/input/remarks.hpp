// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <string>
#include <vector>

#include "configuration/configuration.hpp"

namespace flowslide {

/// What the user should know of values that are allowed but do less than they seem to, one line each:
/// - values of a closed-form sample, such as [elastic], which `engine` does not use;
/// - seed_offsets with fewer numbers than there are replicates.
/// Only values of --config or of an option count. `engine` is the engine of the case. Throws ConfigurationError.
std::vector<std::string> remarks_on(const Configuration& configuration, const std::string& engine);

}  // namespace flowslide
