// SPDX-License-Identifier: GPL-2.0-or-later
// Reads TOML into entries. Only this source uses the TOML library.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "configuration/entry.hpp"

namespace flowslide {

/// The entries of a TOML text, in the order of the text, parents before children. An array of tables becomes a table
/// with the keys "0", "1", ... Messages name `origin` in place of a file. Throws ConfigurationError with origin, line
/// and column if the text is not TOML or is nested too deeply (see nesting.hpp), or if a key is not bare (letters,
/// digits, "_", "-").
std::vector<Entry> read_entries(std::string_view toml, const std::string& origin);

/// The entries of a TOML file. Throws as above, and if the file cannot be read.
std::vector<Entry> read_entries(const std::filesystem::path& file);

/// The entries of "key = value" from a command line, the tables of the key first. Their place is `option`, without a
/// line. The value is read as TOML. A value that is not TOML is read as text, unless it begins like a list, a table or
/// a quoted text; such a value is refused. Throws ConfigurationError for this value, for a key that is not a path of
/// bare keys, and for a key or value that is nested too deeply.
std::vector<Entry> read_option(const std::string& key, const std::string& value, const std::string& option);

}  // namespace flowslide
