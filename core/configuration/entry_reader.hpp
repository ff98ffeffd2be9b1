// SPDX-License-Identifier: GPL-2.0-or-later
// The one place that knows the TOML library.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "configuration/entry.hpp"

namespace flowslide {

/// Lays a TOML text flat, parents before children, in the order of the text; `origin` stands for the file in messages.
/// An array of tables becomes a table with the keys "0", "1", ... Throws ConfigurationError with file, line and column
/// when the text is not TOML, is nested too deeply (see nesting.hpp), or a key is not bare (letters, digits, "_", "-").
std::vector<Entry> read_entries(std::string_view toml, const std::string& origin);

/// The same from a file. Throws ConfigurationError when it cannot be read.
std::vector<Entry> read_entries(const std::filesystem::path& file);

/// The entries of "key = value" from a command line, tables of the key first. A value that is no TOML is taken as text,
/// but for one that begins as a list, a table or a quoted text does: that is refused. Their place is `option`, without
/// line. Throws ConfigurationError when the key is no path of bare keys, or key or value is nested too deeply.
std::vector<Entry> read_option(const std::string& key, const std::string& value, const std::string& option);

}  // namespace flowslide
