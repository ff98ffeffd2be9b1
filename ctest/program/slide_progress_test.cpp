// SPDX-License-Identifier: GPL-2.0-or-later
#include "program/slide_progress.hpp"

#include <sstream>

#include "coupling/elastic_slide.hpp"
#include "support/messages.hpp"

namespace flowslide {
namespace {

/// A ramp on a sample without strength, by RD: v = 500 t^2/m grows, and so do the local steps of an exchange.
struct Ramp {
  SlideSettings settings;
  StopConditions stop{2.0};
  std::ostringstream shown;
  std::chrono::steady_clock::duration now{};
  ProgressStyle style() {
    ProgressStyle style;
    style.stream = &shown;
    style.terminal = true;
    style.columns = 200;
    style.now = [this] { return std::chrono::steady_clock::time_point(now); };
    return style;
  }
};

TEST(SlideProgress, CountsLocalStepsAndScalesThemToTheEnd) {
  Ramp ramp;
  ramp.settings.passing = {WholeIncrement{}, 1e-5, 1000};
  ramp.settings.time_step = 1e-4;
  SlideProgress progress("fig12 RD", ramp.settings, ramp.stop, ramp.style(), {});
  SlideState state;
  state.time = 1.0;
  state.velocity = 0.25;
  state.stress = {1200.0, 3400.0};
  state.local_steps = 30'000;
  // By eq. 15 the rest of the time takes as many steps as the first half: 60 000 in all.
  EXPECT_NEAR(progress.share_done(state), 0.5, 1e-3);
  ramp.now += std::chrono::seconds(3);
  progress.update(state);
  EXPECT_CONTAINS(ramp.shown.str(), "fig12 RD: ");
  EXPECT_CONTAINS(ramp.shown.str(), "10.0k steps/s  3 s left  t 1.000 s, v 0.250 m/s, tau 1200 Pa, sigma 3400 Pa");
  progress.finish(state);
  EXPECT_CONTAINS(ramp.shown.str(), "100 %  30.0k steps in 3 s");
}

TEST(SlideProgress, DoesNotCountTheStepsOfAnEarlierRunInTheSpeed) {
  Ramp ramp;
  ramp.settings.passing = {WholeIncrement{}, 1e-5, 1000};
  SlideState start;
  start.time = 1.0;
  start.local_steps = 30'000;
  SlideProgress progress("RD", ramp.settings, ramp.stop, ramp.style(), start);
  SlideState state = start;
  state.local_steps += 1000;
  ramp.now += std::chrono::seconds(1);
  progress.update(state);
  EXPECT_CONTAINS(ramp.shown.str(), "1.00k steps/s");
}

}  // namespace
}  // namespace flowslide
