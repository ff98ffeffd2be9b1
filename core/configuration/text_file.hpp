// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <filesystem>
#include <string>

namespace flowslide {

/// The text of a file written by the user, in UTF-8, without a byte-order mark. `wanted` names the expected content for
/// messages, such as "a loading table". Throws ConfigurationError if the file cannot be read, if it is UTF-16 or
/// UTF-32, or if it is a folder, a pipe, a socket or a device. Reading a pipe could block.
std::string read_text_file(const std::filesystem::path& file, const std::string& wanted);

}  // namespace flowslide
