// SPDX-License-Identifier: GPL-2.0-or-later
// The folder that a run writes into, and the rules that keep other people's files safe.
#pragma once

#include <array>
#include <filesystem>
#include <set>
#include <string>
#include <string_view>

#include "record/checkpoint_store.hpp"
#include "record/file_lock.hpp"

namespace flowslide {

/// A folder of results of one case. It holds a folder ".flowslide" that says so: a file "case" with the name of the
/// case, and per point the identity of the run that it was begun with (<point>.identity), the lock of the process that
/// runs it (<point>.lock) and, until it is complete, its checkpoints.
class OutputFolder {
 public:
  static constexpr const char* result_end = ".h5";
  /// Ends of the names of all files and folders that cases write for a point; the first is that of its result.
  static constexpr std::array point_ends{result_end, ".dat", "_profiles.dat", "_details.dat", ".md", ".pvd", "_frames"};

  /// Creates the folder where it is absent, and marks it. Throws Refused, before anything is written, when
  /// the path is no folder, cannot be written, holds files but no mark of this program, or belongs to another case.
  static OutputFolder open(const std::filesystem::path& path, const std::string& case_name);
  /// The same without writing anything, for --check: the folder must be there and marked.
  static OutputFolder open_existing(const std::filesystem::path& path, const std::string& case_name);

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path file(const std::string& name) const { return path_ / name; }

  /// Whether the result of a point is there and was not left out.
  bool has_result(const std::string& point) const;
  /// Leaves the result of a point out of what is made of all results, as it is of another run.
  void leave_out(const std::string& point) { left_out_.insert(point); }

  /// The lock of a point, to be held while it runs. Removes what an ended process left half written. Throws
  /// Refused if another process holds it, and std::invalid_argument unless `point` is letters, digits, "_",
  /// "-" and ".".
  [[nodiscard]] FileLock lock_point(const std::string& point) const;
  /// The text of the identity that a point was begun with (see RunIdentity); empty when it was not begun.
  std::string noted(const std::string& point) const;
  void note(const std::string& point, const std::string& identity) const;
  /// Removes the files of a point: its result, its tables, its checkpoints and its note. Its lock must be held.
  void remove_point(const std::string& point) const;
  std::filesystem::path lock_path(const std::string& point) const;
  CheckpointStore checkpoints(const std::string& point) const;

 private:
  explicit OutputFolder(std::filesystem::path path) : path_(std::move(path)) {}
  std::filesystem::path path_;
  std::set<std::string> left_out_;  ///< points
};

}  // namespace flowslide
