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

/// Keeps where one point stands while it runs, and lets it go on from there. All calls but end() are collective over
/// the MPI ranks.
class PointCheckpoints {
 public:
  /// Reads what there is to go on from; damaged files are told on stderr and the one before is used. Throws
  /// Refused, with the difference, if it is of another run, and CorruptFileError if there are checkpoints
  /// and none can be used.
  PointCheckpoints(CheckpointStore store, RunControl& control, const RunIdentity& identity);

  /// What to go on from; empty at the beginning.
  const std::optional<Checkpoint>& found() const { return found_; }

  /// At each border between exchanges: keeps what `now` says if that is due, and throws Stopped if the run is to stop.
  /// A checkpoint that cannot be written (a full disk) is told on stderr, and the run goes on; if it is to stop, that
  /// is a FileError.
  void border(const std::function<Checkpoint()>& now);
  /// The same while a sample is prepared, see RunControl.
  void border_of_preparation(const std::function<bool()>& keep) { control_.border_of_preparation(keep); }
  /// Keeps the end of a run, before anything is computed of it: whatever then happens, the same command has the run.
  void keep_end(const Checkpoint& end) { keep(end, false); }

 private:
  void keep(const Checkpoint& checkpoint, bool stopping);
  std::string label() const;

  CheckpointStore store_;
  RunControl& control_;
  std::optional<Checkpoint> found_;
};

/// Where a checkpoint stands, for people: "t = 0.52 s, v = 1.2 m/s, sigma = 340 Pa".
std::string place_of(const Checkpoint& checkpoint);

}  // namespace flowslide
