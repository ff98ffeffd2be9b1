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

/// The last two checkpoints of one run, <folder>/<name>.checkpoint_0.h5 and <name>.checkpoint_1.h5: HDF5 files with
/// their checksum behind (see sealed_file.hpp), the attribute `checkpoint` of the root being the number, from 1. The
/// newer one is never touched while the next is written, which takes the place of the older one whole or not at all.
/// Not collective: one rank writes and removes; all may read.
class CheckpointStore {
 public:
  CheckpointStore(std::filesystem::path folder, std::string name);

  /// Writes the next checkpoint, which `fill` puts below the root. Throws FileError, with both files as they were.
  void put(const std::function<void(hdf5::Group&)>& fill);

  /// Calls `read` with the newest checkpoint and, if that is torn, altered or not what `read` can use (it throws
  /// CorruptFileError), with the one before. `complain` is told of each that cannot be used. Returns its number; 0 if
  /// there is no checkpoint. Throws CorruptFileError if there are some, and none can be used.
  std::int64_t read_newest(const std::function<void(const hdf5::Group&)>& read,
                           const std::function<void(std::string_view)>& complain) const;

  /// Whether there is one, whole or not.
  bool empty() const;
  void remove() const;
  /// When the newest was written; empty if there is none.
  std::optional<std::filesystem::file_time_type> last_write() const;
  std::filesystem::path path(int place) const;  ///< 0 or 1

 private:
  std::filesystem::path folder_;
  std::string name_;
  std::int64_t last_ = -1;  ///< number of the newest; -1: not known yet
};

}  // namespace flowslide
