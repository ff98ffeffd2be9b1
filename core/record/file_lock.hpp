// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <filesystem>
#include <optional>
#include <string>

namespace flowslide {

/// An exclusive lock between processes (flock), held from construction to destruction. The system releases it when the
/// process ends in any way. The lock file stays, with number and machine of its last holder. On a file system without
/// locks the lock has no effect.
class FileLock {
 public:
  /// The lock if no other process holds it; otherwise empty. Creates the lock file. Throws FileError if the file can be
  /// neither created nor opened.
  static std::optional<FileLock> try_lock(const std::filesystem::path& path);

  /// Whether another process holds the lock now. Creates no file.
  static bool is_held(const std::filesystem::path& path);
  /// Holder of a held lock: "process 1234 on node7", or "another process" if the file does not tell.
  static std::string holder(const std::filesystem::path& path);

  FileLock(FileLock&& other) noexcept;
  FileLock& operator=(FileLock&& other) noexcept;
  ~FileLock();

 private:
  explicit FileLock(int descriptor) : descriptor_(descriptor) {}
  void sign() const;

  int descriptor_ = -1;
};

}  // namespace flowslide
