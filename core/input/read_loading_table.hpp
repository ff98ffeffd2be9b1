// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <filesystem>
#include <string>
#include <string_view>

#include "slope/driving_stress.hpp"

namespace flowslide {

/// Reads a loading table from a text file: per line a time in s and the change of the driving shear stress in Pa,
/// separated by blanks; "#" begins a comment. The decimal sign is a point in every locale. Throws ConfigurationError
/// with file and line if the file cannot be read (see read_text_file) or is no valid table: empty, unsorted, not
/// finite, not two numbers.
StressTable read_loading_table(const std::filesystem::path& file);

/// The same from a text; `origin` stands for the file in messages.
StressTable loading_table_of(std::string_view text, const std::string& origin);

}  // namespace flowslide
