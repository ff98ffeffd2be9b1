// SPDX-License-Identifier: GPL-2.0-or-later
// Kills short runs at random moments (kill -9) and continues them. They end with the files of an uninterrupted run.
#include <random>

#include "restart/program.hpp"

namespace flowslide {
namespace {

using Seconds = std::chrono::duration<double>;

class Kill : public ProgramTest {
 protected:
  /// Kills runs of `point`, `kills` times in all. Continues each run until it is complete.
  void expect_same_after(int kills, const std::string& point, Words options) {
    options.insert(options.end(), {"--point", point});
    ASSERT_EQ(run("whole", options), 0) << said_;  // prepares the sample
    const auto start = std::chrono::steady_clock::now();
    ASSERT_EQ(run("whole_again", options), 0) << said_;
    const Seconds whole = std::chrono::steady_clock::now() - start;
    expect_same_files(point, "whole_again", "whole");

    std::mt19937_64 random(20);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    int killed = 0, runs = 0;
    while (killed < kills) {
      const std::string folder = "killed_" + std::to_string(runs++);
      int code = 0;
      do {
        Process process(command(folder, options), scratch_.path() / "said");
        if (killed < kills) {
          std::this_thread::sleep_for(share(random) * whole);
          process.signal(SIGKILL);
        }
        code = process.wait();
        ASSERT_TRUE(code == 0 || code == 128 + SIGKILL) << code << ": " << process.said();
        killed += code == 0 ? 0 : 1;
      } while (code != 0);
      ASSERT_EQ(run(folder, options), 0) << said_;  // complete: only leftover files are removed
      expect_same_files(point, folder, "whole");
      expect_nothing_left(folder);
      if (HasFailure()) return;
    }
    std::printf("%s: killed %d times in %d runs of %.2f s\n", point.c_str(), killed, runs, whole.count());
  }
};

TEST_F(Kill, FiftyTimesASlideOnGrains) { expect_same_after(50, "RD", {"--engine", "native"}); }

TEST_F(Kill, TwentyTimesAnElementTest) { expect_same_after(20, "alone", {"--engine", "native"}); }

TEST_F(Kill, TwentyTimesASlideOnAClosedFormSample) {
  expect_same_after(20, "RI", {"--set", "stop.end_time=4 s", "--set", "coupling.time_step=1e-5 s"});
}

}  // namespace
}  // namespace flowslide
