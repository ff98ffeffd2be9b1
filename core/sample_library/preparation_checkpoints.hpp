// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "record/checkpoint_store.hpp"
#include "sample/preparation.hpp"

namespace flowslide {

/// Called many times while a sample is prepared or waited for. It may call `keep`, which writes where the preparation
/// stands and says whether it could, and may end the preparation by an exception. Collective over the MPI ranks.
using PreparationBorder = std::function<void(const std::function<bool()>& keep)>;

/// Where the preparation of one sample stands: <key>.checkpoint_*.h5 in the folder of samples, while it is under way.
/// What cannot be read or written is told on stderr and costs no more than time. Collective over the MPI ranks.
class PreparationCheckpoints {
 public:
  PreparationCheckpoints(const std::filesystem::path& folder, std::string key);

  /// What to go on from; empty at the beginning, or if all that there is has been damaged.
  std::optional<PreparationState> find() const;
  /// False if it could not be written.
  bool keep(const PreparationState& state);
  void remove() const;

 private:
  CheckpointStore store_;
  std::string key_;
};

}  // namespace flowslide
