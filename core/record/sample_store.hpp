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

/// A prepared sample as it is kept.
struct StoredSample {
  std::string recipe;               ///< text of all that determined it
  Assembly assembly;
  std::vector<Metric> metrics;      ///< such as void ratio and the stresses reached
};

/// A preparation that came to nothing.
struct FailedSample {
  std::string recipe;  ///< text of all that determined it
  std::string reason;
};

/// Prepared samples in a folder, one file <key>.h5 each, `key` being the hash of the recipe (letters and digits), and
/// what came of those that failed, one text <key>.failed each.
/// Not collective: with several MPI ranks, one of them calls this and broadcasts.
class SampleStore {
 public:
  /// The folder need not be there, nor be writable: it is made by the first lock or sample.
  explicit SampleStore(std::filesystem::path folder);

  /// Whether there is a sample, or the reason of a failure, complete or damaged.
  bool has(const std::string& key) const;
  bool has_failure(const std::string& key) const;
  /// The sample, bit for bit as it was put; empty if there is none. Throws CorruptFileError for a damaged file: it is
  /// never used, and the message says which file to delete.
  std::optional<StoredSample> find(const std::string& key) const;
  /// Keeps `sample`, whole or not at all, in place of one of the same key. Throws std::invalid_argument for an
  /// assembly with a flaw (see flaw_of) or a metric that is not finite, FileError if it cannot be written.
  void put(const std::string& key, const StoredSample& sample) const;
  /// Why the preparation failed; empty if none is known to. Throws as find().
  std::optional<FailedSample> find_failure(const std::string& key) const;
  /// Keeps a failure, whole or not at all. Throws FileError if it cannot be written.
  void put_failure(const std::string& key, const FailedSample& failure) const;
  /// The lock of `key`, or empty if another process holds it. Reading a sample needs none: it is complete as soon as it
  /// is there. Throws FileError if the folder cannot be made or written.
  std::optional<FileLock> try_lock(const std::string& key) const;
  /// Who holds the lock of `key`, as FileLock::holder says.
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
