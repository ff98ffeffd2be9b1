// SPDX-License-Identifier: GPL-2.0-or-later
// When a run is to keep where it stands, and when it is to stop.
#pragma once
#include <chrono>
#include <functional>
#include <limits>
#include <string>

namespace flowslide {

/// What asks a run to stop, the more urgent the later.
enum class StopReason { none, walltime, terminate, interrupt };

/// While one lives, SIGTERM, SIGUSR1 (what a batch system sends before it) and SIGINT are noted instead of ending the
/// program. A second SIGINT ends it at once, with exit code 130.
class StopSignals {
 public:
  StopSignals();
  ~StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;
  /// What has come since the first was made.
  static StopReason received();
};

/// How a run lives with the machine that it is on.
struct RunLimits {
  double checkpoint_interval = 180.0;                            ///< s between checkpoints
  double walltime = std::numeric_limits<double>::infinity();     ///< s from the start of the program
};

/// Decides at each border between exchanges, and is the same on all MPI ranks: a signal to one counts for all.
class RunControl {
 public:
  using Clock = std::function<std::chrono::steady_clock::time_point()>;
  explicit RunControl(const RunLimits& limits, Clock now = std::chrono::steady_clock::now);

  enum class Due { nothing, checkpoint, stop };
  /// What is due now. Collective. The time given is over as soon as another exchange as long as the longest so far, and
  /// two checkpoints, might not end within it.
  Due border();
  /// A checkpoint has been written since the last border, or nothing is to be: the interval begins anew.
  void kept();
  /// A border within the preparation of a sample: calls `keep` when a checkpoint or a stop is due, and throws Stopped
  /// if the run is to stop. `keep` says whether the preparation can go on from there; it has no other way.
  void border_of_preparation(const std::function<bool()>& keep);
  /// Why border() said stop.
  StopReason reason() const { return reason_; }
  /// Throws Stopped: 130 after an interrupt, else 75. `what` is a clause: "fig12 RD_3kPa: the same command goes on".
  [[noreturn]] void stop(const std::string& what) const;

 private:
  double since_start() const;

  RunLimits limits_;
  Clock now_;
  StopSignals signals_;
  std::chrono::steady_clock::time_point start_;
  double last_border_ = 0.0, last_kept_ = 0.0;         ///< s
  double longest_exchange_ = 0.0, longest_write_ = 0.0;  ///< s
  bool kept_since_border_ = true;
  StopReason reason_ = StopReason::none;
};

}  // namespace flowslide
