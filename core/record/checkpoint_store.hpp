// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "record/hdf5.hpp"

namespace flowslide {

/// The last two checkpoints of one run: <folder>/<name>.checkpoint_0.h5 and <name>.checkpoint_1.h5. Both are HDF5 files
/// with a checksum at the end (see sealed_file.hpp). The attribute `checkpoint` of the root is the number, from 1. A
/// new checkpoint replaces the older file, whole or not at all; the newer file is not touched meanwhile. Not
/// collective: one rank writes and removes; all may read.
class CheckpointStore {
 public:
  CheckpointStore(std::filesystem::path folder, std::string name);

  /// Writes the next checkpoint; `fill` writes its content below the root. Throws FileError and then leaves both files
  /// unchanged.
  void put(const std::function<void(hdf5::Group&)>& fill);

  /// Calls `read` with the newest checkpoint. If this one is truncated or altered, or if `read` throws
  /// CorruptFileError, uses the one before. Calls `complain` with a message for each unusable file. Returns the number
  /// of the checkpoint that was read, or 0 if there is none. Throws CorruptFileError if checkpoints exist but none can
  /// be used.
  std::int64_t read_newest(const std::function<void(const hdf5::Group&)>& read,
                           const std::function<void(std::string_view)>& complain) const;

  /// Whether there is no file of a checkpoint, not even a damaged one.
  bool empty() const;
  void remove() const;
  /// Time when the newest checkpoint was written; empty if there is none.
  std::optional<std::filesystem::file_time_type> last_write() const;
  std::filesystem::path path(int place) const;  ///< `place` is 0 or 1

 private:
  std::filesystem::path folder_;
  std::string name_;
  std::int64_t last_ = -1;  ///< number of the newest checkpoint; -1: not known yet
};

}  // namespace flowslide
