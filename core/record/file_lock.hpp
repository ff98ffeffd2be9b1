// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <filesystem>
#include <optional>

namespace flowslide {

/// An exclusive lock between processes (flock): held from construction to destruction, given up by the system when the
/// process ends, however it ends. The lock file stays. On a file system without locks nothing is held.
class FileLock {
 public:
  /// Waits for the lock; creates the file. Throws FileError if it cannot be created.
  explicit FileLock(const std::filesystem::path& path);
  /// The lock if nobody holds it, empty otherwise.
  static std::optional<FileLock> try_lock(const std::filesystem::path& path);

  /// Whether another process holds it now; makes no file.
  static bool is_held(const std::filesystem::path& path);

  FileLock(FileLock&& other) noexcept;
  FileLock& operator=(FileLock&& other) noexcept;
  ~FileLock();

 private:
  explicit FileLock(int descriptor) : descriptor_(descriptor) {}
  int descriptor_ = -1;
};

}  // namespace flowslide
