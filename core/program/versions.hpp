// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <string>

#include "run/run_identity.hpp"

namespace flowslide {

/// Sources and precision of an engine or a closed-form sample. Throws std::invalid_argument for another name.
std::string engine_version(const std::string& name);

/// Those of all that computes a run with these inputs. Throws as engine_version.
RunVersions versions_of(const RunInputs& inputs);

}  // namespace flowslide
