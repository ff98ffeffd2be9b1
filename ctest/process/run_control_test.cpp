// SPDX-License-Identifier: GPL-2.0-or-later
#include "process/run_control.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include "process/exit_code.hpp"
#include "support/messages.hpp"

namespace flowslide {
namespace {

using Due = RunControl::Due;

class RunControlTest : public testing::Test {
 protected:
  RunControl::Clock clock() {
    return [this] { return std::chrono::steady_clock::time_point(now_); };
  }
  void pass(double seconds) {
    now_ += std::chrono::duration_cast<std::chrono::steady_clock::duration>(std::chrono::duration<double>(seconds));
  }
  std::chrono::steady_clock::duration now_{std::chrono::hours(1)};
};

TEST_F(RunControlTest, AsksForACheckpointEveryInterval) {
  RunControl control({.checkpoint_interval = 10.0}, clock());
  EXPECT_EQ(control.poll(), Due::nothing);
  pass(9.0);
  EXPECT_EQ(control.poll(), Due::nothing);
  pass(1.5);
  EXPECT_EQ(control.poll(), Due::checkpoint);
  pass(2.0);  // writing
  control.kept();
  pass(9.0);
  EXPECT_EQ(control.poll(), Due::nothing);
  pass(1.0);
  EXPECT_EQ(control.poll(), Due::checkpoint);
}

TEST_F(RunControlTest, StopsBeforeTheTimeIsOver) {
  RunControl control({.checkpoint_interval = 1e9, .walltime = 100.0}, clock());
  control.poll();
  pass(20.0);
  EXPECT_EQ(control.poll(), Due::nothing);  // exchanges of 20 s
  pass(20.0);
  EXPECT_EQ(control.poll(), Due::nothing);
  pass(20.0);
  EXPECT_EQ(control.poll(), Due::nothing);  // 60 + 20 + 5 < 100
  pass(20.0);
  EXPECT_EQ(control.poll(), Due::stop);  // 80 + 20 + 5 > 100
  EXPECT_EQ(control.reason(), StopReason::walltime);
  try {
    control.stop("it continues");
    FAIL();
  } catch (const Stopped& stopped) {
    EXPECT_EQ(stopped.code(), ExitCode::resumable);
    EXPECT_CONTAINS(stopped.what(), "--max-walltime; it continues");
  }
}

TEST_F(RunControlTest, LeavesTimeForCheckpoints) {
  RunControl control({.checkpoint_interval = 10.0, .walltime = 100.0}, clock());
  control.poll();
  pass(10.0);
  EXPECT_EQ(control.poll(), Due::checkpoint);
  pass(30.0);
  control.kept();
  EXPECT_EQ(control.poll(), Due::stop);  // 40 + 10 + 2 * 30 + 5 > 100
}

TEST_F(RunControlTest, KeepsAPreparationWhenThatIsDue) {
  RunControl control({.checkpoint_interval = 10.0}, clock());
  int kept = 0;
  const auto keep = [&] { return ++kept < 3; };
  control.poll_in_preparation(keep);
  EXPECT_EQ(kept, 0);
  pass(10.0);
  control.poll_in_preparation(keep);
  control.poll_in_preparation(keep);
  EXPECT_EQ(kept, 1);
  ::raise(SIGTERM);
  EXPECT_CONTAINS(message_of<Stopped>([&] { control.poll_in_preparation(keep); }),
                  "the same command continues the preparation");
  EXPECT_CONTAINS(message_of<Stopped>([&] { control.poll_in_preparation(keep); }), "starts again");
}

TEST_F(RunControlTest, StopsOnSignals) {
  for (const auto& [signal, code] : {std::pair{SIGTERM, ExitCode::resumable}, std::pair{SIGUSR1, ExitCode::resumable},
                                     std::pair{SIGINT, ExitCode::interrupted}}) {
    RunControl control({}, clock());
    EXPECT_EQ(control.poll(), Due::nothing);
    ::raise(signal);
    EXPECT_EQ(control.poll(), Due::stop);
    try {
      control.stop("it continues");
      FAIL();
    } catch (const Stopped& stopped) {
      EXPECT_EQ(stopped.code(), code) << signal;
    }
  }
}

TEST_F(RunControlTest, AnInterruptIsMoreUrgentThanTheRest) {
  const RunControl control({}, clock());
  ::raise(SIGINT);
  ::raise(SIGTERM);
  EXPECT_EQ(StopSignals::received(), StopReason::interrupt);
}

TEST_F(RunControlTest, GivesSignalsBack) {
  struct sigaction before {}, after {};
  ::sigaction(SIGTERM, nullptr, &before);
  { const RunControl control({}, clock()); }
  ::sigaction(SIGTERM, nullptr, &after);
  EXPECT_EQ(before.sa_handler, after.sa_handler);
}

TEST(RunControlDeathTest, ASecondInterruptEndsAtOnce) {
  EXPECT_EXIT(
      {
        const StopSignals signals;
        ::raise(SIGINT);
        ::raise(SIGINT);
        ::_exit(0);
      },
      testing::ExitedWithCode(130), "");
}

}  // namespace
}  // namespace flowslide
