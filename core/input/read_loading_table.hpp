// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <filesystem>
#include <string>
#include <string_view>

#include "slope/driving_stress.hpp"

namespace flowslide {

/// Reads a loading table from a text file. Each line has a time (s) and the change of the driving shear stress (Pa,
/// positive downslope), separated by blanks. "#" begins a comment. The decimal sign is a point in every locale. Throws
/// ConfigurationError if the file cannot be read (see read_text_file), if the table is empty, if a line does not have
/// two finite numbers, or if the times do not increase. The message gives file and line.
StressTable read_loading_table(const std::filesystem::path& file);

/// The same from a text. Messages name `origin` in place of a file.
StressTable loading_table_of(std::string_view text, const std::string& origin);

}  // namespace flowslide
