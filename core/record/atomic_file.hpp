// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

namespace flowslide {

/// A file cannot be read or written. The message gives the path, the reason and the remedy.
class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A file can be read, but its content is truncated, altered or of another kind.
class CorruptFileError : public FileError {
 public:
  using FileError::FileError;
};

/// What to do with a file of the same name.
enum class IfExists { refuse, replace };

/// Writes `content` (any bytes) to `path`, whole or not at all: writes a hidden file in the same folder (ending in
/// ".partial"), syncs it and renames it. After an error no new file remains, and an older file at `path` is unchanged.
/// Throws FileError if the folder does not exist or cannot be written, if the disk is full, if `path` is not a regular
/// file, or if it exists and `if_exists` is `refuse`.
void write_atomically(const std::filesystem::path& path, std::string_view content,
                      IfExists if_exists = IfExists::replace);

/// The whole content of a regular file. Throws FileError if the file is missing or cannot be read.
std::string read_file(const std::filesystem::path& path);

}  // namespace flowslide
