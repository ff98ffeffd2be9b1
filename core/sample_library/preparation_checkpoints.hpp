// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "record/checkpoint_store.hpp"
#include "sample/preparation.hpp"

namespace flowslide {

/// Called at each checkpoint opportunity while a sample is prepared or waited for. It may call `keep`, which writes the
/// state of the preparation and returns whether this succeeded. It may throw to end the preparation. Collective over
/// the MPI ranks.
using PreparationPoll = std::function<void(const std::function<bool()>& keep)>;

/// Checkpoints of the preparation of one sample: <key>.checkpoint_*.h5 in the folder of samples until the preparation
/// ends. Errors of reading and writing are reported on stderr; they cost time only. Collective over the MPI ranks.
class PreparationCheckpoints {
 public:
  PreparationCheckpoints(const std::filesystem::path& folder, std::string key);

  /// The newest readable state; empty if there is no checkpoint or if all are damaged.
  std::optional<PreparationState> find() const;
  /// Writes a checkpoint. Returns false if this failed.
  bool keep(const PreparationState& state);
  void remove() const;

 private:
  CheckpointStore store_;
  std::string key_;
};

}  // namespace flowslide
