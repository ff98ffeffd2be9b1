// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <map>
#include <string>

#include "run/output_folder.hpp"
#include "run/run_identity.hpp"

namespace flowslide {

/// Copies the files of the complete points of `output` to `copy` and writes, for those that have a checkpoint, the same
/// tables and result as far as it goes; runs may go on meanwhile. What is there from an earlier call is replaced.
/// Points come with the identity of the run that is asked for: a result or checkpoint of another run is left out.
/// Returns a line for each point: how far it is. Throws Refused if there is nothing yet.
std::string copy_so_far(const OutputFolder& output, const OutputFolder& copy,
                        const std::map<std::string, RunIdentity>& points);

}  // namespace flowslide
