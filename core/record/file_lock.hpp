// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <filesystem>
#include <optional>
#include <string>

namespace flowslide {

/// An exclusive lock between processes (flock): held from construction to destruction, given up by the system when the
/// process ends, however it ends. The lock file stays, with the number and the machine of the process that had it last.
/// On a file system without locks nothing is held.
class FileLock {
 public:
  /// The lock if nobody holds it, empty otherwise. Creates the file. Throws FileError if it can be neither created nor
  /// opened.
  static std::optional<FileLock> try_lock(const std::filesystem::path& path);

  /// Whether another process holds it now; makes no file.
  static bool is_held(const std::filesystem::path& path);
  /// Who holds a lock that is held: "process 1234 on node7", or "another process" if the file does not say.
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
