// SPDX-License-Identifier: GPL-2.0-or-later
// The folder of the results of a case, and rules that protect the files of others.
#pragma once

#include <array>
#include <filesystem>
#include <set>
#include <string>
#include <string_view>

#include "record/checkpoint_store.hpp"
#include "record/file_lock.hpp"

namespace flowslide {

/// A folder of results of one case; "point" is the name of a run of the case. The folder is marked by a folder
/// ".flowslide". In it, the file "case" holds the name of the case. For each run it has the identity with which the run
/// was begun (<point>.identity), the lock of the process that runs it (<point>.lock) and, until the run is complete,
/// its checkpoints.
class OutputFolder {
 public:
  static constexpr const char* result_end = ".h5";
  /// Ends of the names of all files and folders that cases write for a run; the first is that of its result.
  static constexpr std::array point_ends{result_end, ".dat", "_profiles.dat", "_details.dat", ".md", ".pvd", "_frames"};

  /// Creates the folder if it is absent, and marks it. Throws Refused if the path is not a folder, cannot be written,
  /// holds files but no mark of this program, or belongs to another case.
  static OutputFolder open(const std::filesystem::path& path, const std::string& case_name);
  /// The same without writing, for --check. Throws Refused also if the folder is absent or not marked.
  static OutputFolder open_existing(const std::filesystem::path& path, const std::string& case_name);

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path file(const std::string& name) const { return path_ / name; }

  /// Whether the result of a run exists and was not left out.
  bool has_result(const std::string& point) const;
  /// Excludes the result of a run from figures and claims, because it has another identity.
  void leave_out(const std::string& point) { left_out_.insert(point); }

  /// The lock of a run, to be held until the run ends. Removes incomplete files of an earlier process. Throws Refused
  /// if another process holds the lock, and std::invalid_argument unless `point` consists of letters, digits, "_", "-",
  /// ".".
  [[nodiscard]] FileLock lock_point(const std::string& point) const;
  /// The text of the identity with which a run was begun (see RunIdentity); empty if it was not begun.
  std::string noted(const std::string& point) const;
  /// Records this text.
  void note(const std::string& point, const std::string& identity) const;
  /// Removes the files of a run: result, tables, checkpoints and identity. Precondition: its lock is held.
  void remove_point(const std::string& point) const;
  std::filesystem::path lock_path(const std::string& point) const;
  CheckpointStore checkpoints(const std::string& point) const;

 private:
  explicit OutputFolder(std::filesystem::path path) : path_(std::move(path)) {}
  std::filesystem::path path_;
  std::set<std::string> left_out_;  ///< names of runs
};

}  // namespace flowslide
