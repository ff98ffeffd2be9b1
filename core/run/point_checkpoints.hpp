// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <functional>
#include <optional>
#include <string>

#include "process/run_control.hpp"
#include "record/checkpoint_store.hpp"
#include "run/checkpoint.hpp"
#include "run/run_identity.hpp"

namespace flowslide {

/// Writes the checkpoints of one run ("point") and reads them when the run continues. All calls are collective over the
/// MPI ranks.
class PointCheckpoints {
 public:
  /// Reads the newest checkpoint. Damaged files are reported on stderr, and the one before is used. Throws Refused,
  /// with the difference, if the checkpoint has another identity. Throws CorruptFileError if there are checkpoints but
  /// none can be used.
  PointCheckpoints(CheckpointStore store, RunControl& control, const RunIdentity& identity);

  /// The checkpoint to continue from; empty if there is none.
  const std::optional<Checkpoint>& found() const { return found_; }

  /// Call at each checkpoint opportunity between two exchanges. Writes the checkpoint that `now` returns if it is due,
  /// and throws Stopped if the run is to stop. If the checkpoint cannot be written (a full disk), a run that continues
  /// reports this on stderr, and a run that stops throws FileError.
  void poll(const std::function<Checkpoint()>& now);
  /// The same while a sample is prepared, see RunControl.
  void poll_in_preparation(const std::function<bool()>& keep) { control_.poll_in_preparation(keep); }
  /// Writes the state at the end of a run, before results are computed from it. If their computation fails, the same
  /// command continues from this state.
  void keep_end(const Checkpoint& end) { keep(end, false); }

 private:
  void keep(const Checkpoint& checkpoint, bool stopping);
  std::string label() const;

  CheckpointStore store_;
  RunControl& control_;
  std::optional<Checkpoint> found_;
};

/// State of a checkpoint in one line: "t = 0.52 s, v = 1.2 m/s, sigma = 340 Pa".
std::string place_of(const Checkpoint& checkpoint);

}  // namespace flowslide
