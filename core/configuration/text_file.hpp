// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <filesystem>
#include <string>

namespace flowslide {

/// The text of a file that a user has written, in UTF-8, without a byte-order mark. `wanted` says what it should be,
/// such as "a loading table". Throws ConfigurationError if it cannot be read, is no regular file (a pipe would be
/// waited for), or is UTF-16 or UTF-32.
std::string read_text_file(const std::filesystem::path& file, const std::string& wanted);

}  // namespace flowslide
