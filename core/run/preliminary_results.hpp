// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <map>
#include <string>

#include "run/output_folder.hpp"
#include "run/run_identity.hpp"

namespace flowslide {

/// Makes preliminary results: copies the files of the complete runs of `output` to `copy`, and writes the tables and
/// results of runs that have a checkpoint, up to this checkpoint. Replaces files of an earlier call. The runs may
/// continue meanwhile. `points` gives the required identity of each run; a result or checkpoint of another identity is
/// left out. Returns a line with the progress of each run. Throws Refused if no run has a result or a checkpoint yet.
std::string copy_preliminary_results(const OutputFolder& output, const OutputFolder& copy,
                                     const std::map<std::string, RunIdentity>& points);

}  // namespace flowslide
