// SPDX-License-Identifier: GPL-2.0-or-later
#include "process/run_control.hpp"

#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <utility>

#include "process/exit_code.hpp"
#include "process/mpi_session.hpp"

namespace flowslide {
namespace {

constexpr std::array stop_signals{SIGTERM, SIGUSR1, SIGINT};

/// Reserve between the last checkpoint opportunity and the end of the program, besides exchange and checkpoints: a
/// fraction of the wall time limit, and its upper bound (s).
constexpr double walltime_share = 0.05, longest_reserve = 5.0;

volatile sig_atomic_t received_reason = 0;
int signal_users = 0;
std::array<struct sigaction, stop_signals.size()> previous_actions;

void record_signal(int signal) {
  if (signal == SIGINT) {
    if (received_reason == static_cast<int>(StopReason::interrupt)) ::_exit(to_int(ExitCode::interrupted));
    received_reason = static_cast<int>(StopReason::interrupt);
  } else if (received_reason == 0) {
    received_reason = static_cast<int>(StopReason::terminate);
  }
}

}  // namespace

StopSignals::StopSignals() {
  if (signal_users++ > 0) return;
  received_reason = 0;
  struct sigaction action {};
  action.sa_handler = record_signal;
  action.sa_flags = SA_RESTART;
  ::sigemptyset(&action.sa_mask);
  for (std::size_t i = 0; i < stop_signals.size(); ++i) ::sigaction(stop_signals[i], &action, &previous_actions[i]);
}

StopSignals::~StopSignals() {
  if (--signal_users > 0) return;
  for (std::size_t i = 0; i < stop_signals.size(); ++i) ::sigaction(stop_signals[i], &previous_actions[i], nullptr);
}

StopReason StopSignals::received() { return static_cast<StopReason>(received_reason); }

RunControl::RunControl(const RunLimits& limits, Clock now) : limits_(limits), now_(std::move(now)), start_(now_()) {}

double RunControl::since_start() const { return std::chrono::duration<double>(now_() - start_).count(); }

RunControl::Due RunControl::poll() {
  const double now = since_start();
  // The first interval after a checkpoint includes its writing, which longest_write_ already counts.
  if (!kept_since_poll_) longest_exchange_ = std::max(longest_exchange_, now - last_poll_);
  kept_since_poll_ = false;
  last_poll_ = now;
  const double needed = longest_exchange_ + 2.0 * longest_write_ +
                        std::min(walltime_share * limits_.walltime, longest_reserve);
  int wanted = static_cast<int>(StopSignals::received());
  if (wanted == 0 && now + needed > limits_.walltime) wanted = static_cast<int>(StopReason::walltime);
  const bool interval_over = now - last_kept_ >= limits_.checkpoint_interval;
  std::array<double, 2> all{static_cast<double>(wanted), interval_over ? 1.0 : 0.0};
  largest_over_ranks(all);
  reason_ = static_cast<StopReason>(static_cast<int>(all[0]));
  if (reason_ != StopReason::none) return Due::stop;
  return all[1] != 0 ? Due::checkpoint : Due::nothing;
}

void RunControl::kept() {
  last_kept_ = since_start();
  longest_write_ = std::max(longest_write_, last_kept_ - last_poll_);
  kept_since_poll_ = true;
}

void RunControl::poll_in_preparation(const std::function<bool()>& keep) {
  const Due due = poll();
  if (due == Due::nothing) return;
  const bool kept_it = keep();
  kept();
  if (due == Due::stop)
    stop(kept_it ? "its sample is being prepared; the same command continues the preparation"
                 : "the interrupted work has no checkpoint and starts again; complete samples are kept in the cache");
}

void RunControl::stop(const std::string& what) const {
  const char* why = reason_ == StopReason::interrupt ? "interrupted"
                    : reason_ == StopReason::walltime ? "out of the time given by --max-walltime"
                                                      : "asked to end by a signal";
  throw Stopped(reason_ == StopReason::interrupt ? ExitCode::interrupted : ExitCode::resumable,
                fmt::format("{}; {}", why, what));
}

}  // namespace flowslide
