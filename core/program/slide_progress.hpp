// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <string>

#include "coupling/slide.hpp"
#include "coupling/stop.hpp"
#include "process/progress.hpp"

namespace flowslide {

/// Progress of a slide, counted in local steps. Local steps take nearly all of the time. The faster the slope slides,
/// the more of them an exchange needs. Their total N is not known and is estimated as N = n P/p. n is the number of
/// steps so far. P and p are the predicted steps (see predicted_steps) in total and up to the present time.
class SlideProgress {
 public:
  /// `start`: the present state of the slide.
  SlideProgress(const std::string& label, const SlideSettings& settings, const StopConditions& stop,
                const ProgressStyle& style, const SlideState& start);
  /// Call it after each exchange. It is cheap.
  void update(const SlideState& state);
  void finish(const SlideState& state);
  /// Estimated fraction of the local steps that are done, 0 to 1.
  double share_done(const SlideState& state) const;

 private:
  std::int64_t steps_in_all(const SlideState& state) const;

  SlideSettings settings_;
  StopConditions stop_;
  double free_steps_;  ///< predicted steps in total, P
  Progress progress_;
};

/// The state for a progress line: "t 0.520 s, v 1.200 m/s, tau 3100 Pa, sigma 12000 Pa".
std::string state_text(const SlideState& state);

}  // namespace flowslide
