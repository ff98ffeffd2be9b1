// SPDX-License-Identifier: GPL-2.0-or-later
// Which keys a study may sweep.
#pragma once
#include <string>

#include "sweep.hpp"

namespace flowslide {

/// Finds the table and the name of the key that `sweep.key` means, and sets both in `sweep`. Throws ConfigurationError
/// as read_sweep, also for a key that exists but changes no result of this engine.
void find_swept_key(const Configuration& configuration, const std::string& engine, const std::string& sample,
                    Sweep& sweep);

}  // namespace flowslide
