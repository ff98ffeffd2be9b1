// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "grains/assembly.hpp"
#include "record/atomic_file.hpp"
#include "record/file_lock.hpp"
#include "record/series.hpp"

namespace flowslide {

/// A prepared sample in the store.
struct StoredSample {
  std::string recipe;               ///< text of all that determined it
  Assembly assembly;
  std::vector<Metric> metrics;      ///< such as void ratio and the stresses reached
};

/// A failed preparation in the store.
struct FailedSample {
  std::string recipe;  ///< text of all that determined it
  std::string reason;
};

/// A folder of prepared samples, one file <key>.h5 each, and of failed preparations, one text <key>.failed each. `key`
/// is the hash of the recipe (letters and digits). Not collective: with several MPI ranks, one rank writes.
class SampleStore {
 public:
  /// The folder may be absent or read-only. The first lock or sample creates it.
  explicit SampleStore(std::filesystem::path folder);

  /// Whether the store has the file of a sample. The file may be damaged.
  bool has(const std::string& key) const;
  /// The same for the file of a failure.
  bool has_failure(const std::string& key) const;
  /// The sample, bit for bit as it was put; empty if there is none. Throws CorruptFileError for a damaged file; the
  /// message says which file to delete.
  std::optional<StoredSample> find(const std::string& key) const;
  /// Writes `sample`, whole or not at all, and replaces an older one. Throws std::invalid_argument for an assembly with
  /// a flaw (see flaw_of) or a metric that is not finite, and FileError if the file cannot be written.
  void put(const std::string& key, const StoredSample& sample) const;
  /// The failure of a preparation; empty if none is recorded. Throws as find().
  std::optional<FailedSample> find_failure(const std::string& key) const;
  /// Writes a failure, whole or not at all. Throws FileError if the file cannot be written.
  void put_failure(const std::string& key, const FailedSample& failure) const;
  /// The lock of `key`, or empty if another process holds it. Reading needs no lock, because a sample appears only when
  /// it is complete. Throws FileError if the folder cannot be made or written.
  std::optional<FileLock> try_lock(const std::string& key) const;
  /// The holder of the lock of `key`, see FileLock::holder.
  std::string holder(const std::string& key) const;
  /// <folder>/<key>.h5. Throws std::invalid_argument for a key that is empty or not of letters and digits.
  std::filesystem::path path(const std::string& key) const;
  /// <folder>/<key>.failed. Throws as path().
  std::filesystem::path failure_path(const std::string& key) const;

 private:
  void make_folder() const;
  std::filesystem::path lock_path(const std::string& key) const;

  std::filesystem::path folder_;
};

}  // namespace flowslide
