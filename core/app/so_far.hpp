// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <string>
#include <vector>

#include "app/output_folder.hpp"

namespace flowslide {

/// Copies the files of the complete points of `output` to `copy` and writes, for those that have a checkpoint, the same
/// tables and result as far as it goes; runs may go on meanwhile. What is there from an earlier call is replaced.
/// Returns a line for each point: how far it is. Throws ConfigurationError if there is nothing yet.
std::string copy_so_far(const OutputFolder& output, const OutputFolder& copy, const std::vector<std::string>& points);

}  // namespace flowslide
