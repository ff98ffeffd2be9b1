// SPDX-License-Identifier: GPL-2.0-or-later
// When a run writes a checkpoint, and when it stops. The run asks at each checkpoint opportunity, between two
// exchanges.
#pragma once
#include <chrono>
#include <functional>
#include <limits>
#include <string>

namespace flowslide {

/// Reasons to stop a run, in order of urgency.
enum class StopReason { none, walltime, terminate, interrupt };

/// While an object of this class exists, SIGTERM, SIGUSR1 and SIGINT are recorded instead of ending the program. Batch
/// systems send SIGUSR1 before SIGTERM. A second SIGINT ends the program at once, with exit code 130.
class StopSignals {
 public:
  StopSignals();
  ~StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;
  /// The most urgent signal since the first object was made.
  static StopReason received();
};

/// Limits in wall time.
struct RunLimits {
  double checkpoint_interval = 180.0;                            ///< time between checkpoints, s
  double walltime = std::numeric_limits<double>::infinity();     ///< limit from the start of the RunControl, s
};

/// Decides at each checkpoint opportunity whether the run writes a checkpoint or stops. All MPI ranks decide the same:
/// a signal to one rank counts for all.
class RunControl {
 public:
  using Clock = std::function<std::chrono::steady_clock::time_point()>;
  explicit RunControl(const RunLimits& limits, Clock now = std::chrono::steady_clock::now);

  enum class Due { nothing, checkpoint, stop };
  /// Call at each checkpoint opportunity; returns what is due. Collective. Stops early: when the remaining wall time is
  /// less than the longest exchange so far plus two checkpoint writes and a reserve of at most 5 s.
  Due poll();
  /// Call after a checkpoint was written, or if none is to be written. The checkpoint interval starts again.
  void kept();
  /// The same at a checkpoint opportunity within the preparation of a sample. Calls `keep` if a checkpoint or a stop is
  /// due, and throws Stopped if the run is to stop. `keep` returns whether it wrote a checkpoint to continue from.
  void poll_in_preparation(const std::function<bool()>& keep);
  /// Why poll() returned Due::stop.
  StopReason reason() const { return reason_; }
  /// Throws Stopped, with exit code 130 after an interrupt and 75 otherwise. `what` is the last clause of its message:
  /// "the same command continues from t = 0.52 s".
  [[noreturn]] void stop(const std::string& what) const;

 private:
  double since_start() const;

  RunLimits limits_;
  Clock now_;
  StopSignals signals_;
  std::chrono::steady_clock::time_point start_;
  double last_poll_ = 0.0, last_kept_ = 0.0;             ///< s
  double longest_exchange_ = 0.0, longest_write_ = 0.0;  ///< s
  bool kept_since_poll_ = true;
  StopReason reason_ = StopReason::none;
};

}  // namespace flowslide
