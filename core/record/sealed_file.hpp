// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "record/atomic_file.hpp"

namespace flowslide {

/// Number of bytes that `write_sealed` appends to the content: "\nflowslide xxh3 <32 digits>\n". HDF5 ignores them. The
/// command `head -c -49 FILE | xxhsum -H128` computes the same checksum.
inline constexpr std::size_t seal_size = 49;

/// Writes `content` and its seal, whole or not at all. Throws as write_atomically.
void write_sealed(const std::filesystem::path& path, std::string_view content, IfExists if_exists);

/// The content without its seal. Throws CorruptFileError if the seal is missing or if any bit of the file has changed.
/// `remedy` ends the message: what the user can do.
std::string read_sealed(const std::filesystem::path& path, std::string_view remedy);

}  // namespace flowslide
