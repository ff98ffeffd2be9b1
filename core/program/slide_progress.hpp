// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <string>

#include "coupling/slide.hpp"
#include "coupling/stop.hpp"
#include "process/progress.hpp"

namespace flowslide {

/// Progress of a slide in local steps, which are what takes time: an exchange takes the more of them the faster the
/// slope slides. How many there will be is not known: those so far, times what a slope on a sample without strength
/// takes in all over what it takes up to the same time.
class SlideProgress {
 public:
  /// `start`: where the slide stands now.
  SlideProgress(const std::string& label, const SlideSettings& settings, const StopConditions& stop,
                const ProgressStyle& style, const SlideState& start);
  /// After an exchange; cheap.
  void update(const SlideState& state);
  void finish(const SlideState& state);
  /// About, 0 to 1.
  double share_done(const SlideState& state) const;

 private:
  std::int64_t steps_in_all(const SlideState& state) const;

  SlideSettings settings_;
  StopConditions stop_;
  double free_steps_;  ///< of a slope on a sample without strength, until its end
  Progress progress_;
};

/// "t 0.52 s, v 1.2 m/s, tau 3.1 kPa, sigma 12 kPa".
std::string state_text(const SlideState& state);

}  // namespace flowslide
