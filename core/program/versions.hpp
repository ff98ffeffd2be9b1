// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <string>

#include "run/run_identity.hpp"

namespace flowslide {

/// The version of an engine or closed-form sample: a hash of its sources, and the precision of an engine. Throws
/// std::invalid_argument for any other name.
std::string engine_version(const std::string& name);

/// The versions of the run, the engine, the preparation and the search for a run with these inputs. Throws as
/// engine_version.
RunVersions versions_of(const RunInputs& inputs);

}  // namespace flowslide
