// SPDX-License-Identifier: GPL-2.0-or-later
// The folder that a run writes into, and the rules that keep other people's files safe.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "record/checkpoint_store.hpp"
#include "record/file_lock.hpp"

namespace flowslide {

/// A folder of results of one case. It holds a folder ".flowslide" that says so: a file "case" with the name of the
/// case, and per point the hash of the configuration that it was run with (<point>.hash), that configuration
/// (<point>.toml), the lock of the process that runs it (<point>.lock) and, until it is complete, its checkpoints.
class OutputFolder {
 public:
  /// Creates the folder where it is absent, and marks it. Throws ConfigurationError, before anything is written, when
  /// the path is no folder, cannot be written, holds files but no mark of this program, or belongs to another case.
  static OutputFolder open(const std::filesystem::path& path, const std::string& case_name);
  /// The same without writing anything, for --check: the folder must be there and marked.
  static OutputFolder open_existing(const std::filesystem::path& path, const std::string& case_name);

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path file(const std::string& name) const { return path_ / name; }

  /// The hash a point was begun with; empty when it was not begun.
  std::string hash_of(const std::string& point) const;
  /// Notes that a point is begun with a resolved configuration and its hash. The lock is to be held while it runs: that
  /// another process holds it is a ConfigurationError, as is that the point was begun with another configuration (the
  /// message shows the difference). What an ended process left half written is removed. `point` must be letters,
  /// digits, "_", "-", "." or std::invalid_argument is thrown.
  [[nodiscard]] FileLock begin_point(const std::string& point, const std::string& hash,
                                     const std::string& configuration) const;
  std::filesystem::path lock_path(const std::string& point) const;
  CheckpointStore checkpoints(const std::string& point) const;

 private:
  explicit OutputFolder(std::filesystem::path path) : path_(std::move(path)) {}
  std::filesystem::path path_;
};

}  // namespace flowslide
