// SPDX-License-Identifier: GPL-2.0-or-later
#include "program/slide_progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "program/slide_point.hpp"

namespace flowslide {
namespace {

/// Smallest fraction p/P at which n P/p is used. Below it the total is P.
constexpr double telling_share = 1e-3;

}  // namespace

std::string state_text(const SlideState& state) {
  return fmt::format("t {:.3f} s, v {:.3f} m/s, tau {:.0f} Pa, sigma {:.0f} Pa", state.time, state.velocity,
                     state.stress.shear, state.stress.normal);
}

SlideProgress::SlideProgress(const std::string& label, const SlideSettings& settings, const StopConditions& stop,
                             const ProgressStyle& style, const SlideState& start)
    : settings_(settings),
      stop_(stop),
      free_steps_(predicted_steps(settings, stop)),
      progress_(label, steps_in_all(start), style, start.local_steps) {}

std::int64_t SlideProgress::steps_in_all(const SlideState& state) const {
  StopConditions until = stop_;
  until.end_time = std::clamp(state.time, 0.0, stop_.end_time);
  const double free_so_far = until.end_time > 0.0 ? predicted_steps(settings_, until) : 0.0;
  const auto done = static_cast<double>(state.local_steps);
  const double share = free_so_far / free_steps_;
  const double all = share > telling_share ? done / std::min(share, 1.0) : free_steps_;
  return std::max<std::int64_t>(state.local_steps, std::llround(std::min(all, 1e15)));
}

void SlideProgress::update(const SlideState& state) {
  if (!progress_.due()) return;
  progress_.set_total(steps_in_all(state));
  progress_.update(state.local_steps, state_text(state));
}

double SlideProgress::share_done(const SlideState& state) const {
  const std::int64_t all = steps_in_all(state);
  return all > 0 ? static_cast<double>(state.local_steps) / static_cast<double>(all) : 0.0;
}

void SlideProgress::finish(const SlideState& state) {
  progress_.set_total(state.local_steps);
  progress_.update(state.local_steps);
  progress_.finish(state_text(state));
}

}  // namespace flowslide
