// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <filesystem>
#include <string>
#include <string_view>

#include "record/input_table.hpp"
#include "slope/driving_stress.hpp"

namespace flowslide {

/// Reads a loading table from a text file: per line a time in s and the change of the driving shear stress in Pa,
/// separated by blanks; "#" begins a comment. The decimal sign is a point in every locale. Throws ConfigurationError
/// with file and line if the file cannot be read (see read_text_file) or is no valid table: empty, unsorted, not
/// finite, not two numbers.
StressTable read_loading_table(const std::filesystem::path& file);

/// The same from a text; `origin` stands for the file in messages.
StressTable loading_table_of(std::string_view text, const std::string& origin);

/// A loading table as a result keeps it: columns "time" (s) and "stress_change" (Pa). `file` is its name in the
/// configuration.
InputTable input_table(const std::string& file, const StressTable& table);

/// The table that input_table was given. Throws std::out_of_range if `input` has no such columns.
StressTable stress_table(const InputTable& input);

}  // namespace flowslide
