// SPDX-License-Identifier: GPL-2.0-or-later
// Output that cannot be written: a clear message and an unchanged last checkpoint; with free space the run continues.
#include <sys/mount.h>

#include "restart/program.hpp"

namespace flowslide {
namespace {

class Output : public ProgramTest {
 protected:
  Words options_{"--engine", "native", "--point", "RD"};
  std::filesystem::path checkpoint(int place) const {
    return CheckpointStore(out("out") / ".flowslide", "RD").path(place);
  }
  /// Some checkpoints, and an end by SIGTERM.
  void stop_a_run() {
    ASSERT_EQ(run("whole", options_), 0) << said_;
    const auto process = start("out", "RD", options_);
    process->signal(SIGTERM);
    ASSERT_EQ(process->wait(), 75) << process->said();
  }
};

TEST_F(Output, OnAFullFileSystem) {
  std::filesystem::create_directory(out("out"));
  if (::mount("none", out("out").c_str(), "tmpfs", 0, "size=4m") != 0)
    GTEST_SKIP() << "no tmpfs can be mounted here; point_checkpoints_test fills a disk in process";
  stop_a_run();
  const auto checkpoints = [&] { return content_of(checkpoint(0)) + content_of(checkpoint(1)); };
  const std::string before = checkpoints();
  const auto ballast = out("out") / ".flowslide" / "ballast";
  const auto free = std::filesystem::space(out("out")).available;
  std::ofstream(ballast, std::ios::binary) << std::string(free > 16384 ? free - 16384 : 0, 'x');
  EXPECT_EQ(run("out", options_), 2) << said_;
  EXPECT_CONTAINS(said_, "No space left on device; free some space or choose another folder");
  EXPECT_CONTAINS(said_, "the same command continues from its last checkpoint");
  EXPECT_EQ(checkpoints(), before);
  EXPECT_FALSE(std::filesystem::exists(out("out") / "RD.h5"));
  std::filesystem::remove(ballast);

  // Read-only, it says so before a run is spent on it.
  ASSERT_EQ(::mount("none", out("out").c_str(), "tmpfs", MS_REMOUNT | MS_RDONLY, "size=4m"), 0);
  for (const char* point : {"RD", "alone"}) {
    EXPECT_EQ(run("out", {"--engine", "native", "--point", point}), 2);
    EXPECT_CONTAINS(said_, "cannot be written");
    EXPECT_CONTAINS(said_, "Read-only file system");
  }
  EXPECT_EQ(checkpoints(), before);
  ASSERT_EQ(::mount("none", out("out").c_str(), "tmpfs", MS_REMOUNT, "size=4m"), 0);

  EXPECT_EQ(run("out", options_), 0) << said_;
  EXPECT_CONTAINS(said_, "continues from its checkpoint at ");
  expect_same_files("RD", "out", "whole");
  expect_nothing_left("out");
  EXPECT_EQ(::umount2(out("out").c_str(), MNT_DETACH), 0);
}

/// In the child, before the program takes its place.
void give_full_output() { ::dup2(::open("/dev/full", O_WRONLY), STDOUT_FILENO); }

TEST_F(Output, ThatIsPrintedNowhereIsAnError) {
  scratch_.write("claims.toml",
                 "[[claim]]\nid = \"rows\"\nfigure = \"Fig. 12\"\nsentence = \"It has rows.\"\n"
                 "metric = \"RD.rows\"\nrelation = \">\"\nthreshold = 0\nunit = \"1\"\norigin = \"no rounding\"\n");
  ASSERT_EQ(run("out", {"--engine", "elastic", "--point", "RD"}), 0) << said_;
  for (const Words& options : {Words{"--help"},
                               {"--version"},
                               {"--list"},
                               {"--list", "--json"},
                               {"--dry-run"},
                               {"--status"},
                               {"--status", "--json"},
                               {"--check"},
                               {"--so-far"}}) {
    Words words{"--engine", "elastic"};
    words.insert(words.end(), options.begin(), options.end());
    ASSERT_EQ(run("out", words), 0) << options[0] << "\n" << said_;
    EXPECT_EQ(run("out", words, give_full_output), 1) << options[0];
    EXPECT_CONTAINS(said_, "flowslide: standard output cannot be written: No space left on device");
  }
}

TEST_F(Output, NeedsNoEnvironment) {
  const std::string folder = scratch_.path().string();
  const auto bare = [&] {
    ::clearenv();
    ::setenv("RESTARTABLE_CASE", folder.c_str(), 1);
  };
  for (const char* option : {"--help", "--version", "--list"}) {
    EXPECT_EQ(run("out", {option}, bare), 0) << said_;
    EXPECT_FALSE(said_.empty());
  }
  EXPECT_EQ(run("out", {"--engine", "elastic", "--point", "RD"}, bare), 0) << said_;
}

TEST_F(Output, OfSlidesThatBlowUpIsTheFaultOfTheNumbers) {
  EXPECT_EQ(run("out", {"--engine", "elastic", "--point", "RD", "--allow-unstable", "--set", "coupling.time_step=0.1 s",
                        "--set", "stop.end_time=1e6 s", "--set", "rows.row_strain=1e6"}),
            3);
  EXPECT_CONTAINS(said_, "flowslide: the slide is not finite at t = ");
}

}  // namespace
}  // namespace flowslide
