// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <filesystem>

#include "slope/driving_stress.hpp"

namespace flowslide {

/// Reads a loading table from a text file: per line a time in s and the change of the driving shear stress in Pa,
/// separated by blanks; "#" begins a comment. Throws ConfigurationError with file and line if the file cannot be read
/// or is no valid table: empty, unsorted, not finite, not two numbers.
StressTable read_loading_table(const std::filesystem::path& file);

}  // namespace flowslide
