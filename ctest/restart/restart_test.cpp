// SPDX-License-Identifier: GPL-2.0-or-later
// Whole programs that are stopped and continue: the results have the same bits as without a stop.
#include "program.hpp"

namespace flowslide {
namespace {

class Restart : public ProgramTest {
 protected:
  /// A point stopped by each signal in turn until it is over, against one that was not.
  void expect_same_after_stops(const std::string& point, const Words& options) {
    Words all{"--point", point};
    all.insert(all.end(), options.begin(), options.end());
    ASSERT_EQ(run("whole", all), 0) << said_;
    int stops = 0;
    for (const auto& [signal, code] : {std::pair{SIGTERM, 75}, std::pair{SIGUSR1, 75}, std::pair{SIGINT, 130}}) {
      const auto process = start("stopped", point, all);
      process->signal(signal);
      const int ended = process->wait();
      if (ended == 0) break;
      ASSERT_EQ(ended, code) << process->said();
      EXPECT_CONTAINS(process->said(), "the same command continues from ");
      ++stops;
    }
    EXPECT_GT(stops, 0);
    Words resumed = all;
    resumed.push_back("--resume");
    ASSERT_EQ(run("stopped", resumed), 0) << said_;
    EXPECT_CONTAINS(said_, "continues from its checkpoint at ");
    expect_same_files(point, "stopped", "whole");
    expect_nothing_left("stopped");
  }
};

TEST_F(Restart, ASlideOnGrainsGoesOnWithTheSameBits) { expect_same_after_stops("RD", {"--engine", "native"}); }

TEST_F(Restart, AnElementTestGoesOnWithTheSameBits) { expect_same_after_stops("alone", {"--engine", "native"}); }

TEST_F(Restart, GoesOnWithTheSameBitsOnMoreThreads) {
  const Words options{"--engine", "native", "--point", "RD"};
  ASSERT_EQ(run("whole", options), 0) << said_;
  const auto process = start("stopped", "RD", options);
  process->signal(SIGTERM);
  ASSERT_EQ(process->wait(), 75) << process->said();
  Words on_two = options;
  on_two.insert(on_two.end(), {"--threads", "2"});
  ASSERT_EQ(run("stopped", on_two), 0) << said_;
  EXPECT_CONTAINS(said_, "continues from its checkpoint at ");
  expect_same_files("RD", "stopped", "whole");
}

TEST_F(Restart, GoesOnWithTheSameStressOnLiggghts) {
  // To its peak and a little further; later, differences by rounding grow exponentially.
  const Words options{"--engine", "liggghts", "--point", "alone", "--set", "point.alone.final_strain=0.01"};
  ASSERT_EQ(run("whole", options), 0) << said_;
  const auto process = start("stopped", "alone", options);
  process->signal(SIGTERM);
  ASSERT_EQ(process->wait(), 75) << process->said();
  ASSERT_EQ(run("stopped", options), 0) << said_;
  EXPECT_CONTAINS(said_, "continues from its checkpoint at ");
  const Series stopped = read_result(out("stopped") / "alone.h5").series;
  const Series whole = read_result(out("whole") / "alone.h5").series;
  ASSERT_EQ(stopped.rows(), whole.rows());
  const double scale = whole.column("normal_stress").values.front();
  for (const char* name : {"shear_stress", "normal_stress"})
    for (std::size_t row = 0; row < whole.rows(); ++row)
      EXPECT_NEAR(stopped.column(name).values[row], whole.column(name).values[row], 1e-12 * scale)
          << name << " " << row;
}

TEST_F(Restart, ASecondInterruptEndsAtOnce) {
  ASSERT_EQ(run("whole", {"--engine", "native", "--point", "alone"}), 0) << said_;  // its sample is there from now on
  // A test whose rows, at which it may end, are far apart: many seconds.
  const Words long_test{"--engine", "native",
                        "--point",  "alone",
                        "--set",    "shear_test.rows=10",
                        "--set",    "point.alone.final_strain=100",
                        "--set",    "coupling.local_time_step=1e-7 s"};
  Process process(command("out", long_test), scratch_.path() / "out.said");
  std::this_thread::sleep_for(std::chrono::seconds(1));
  process.signal(SIGINT);
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  EXPECT_TRUE(process.runs()) << process.said();
  process.signal(SIGINT);
  EXPECT_EQ(process.wait(), 128 + SIGINT);
  EXPECT_EQ(process.said().find("interrupted;"), std::string::npos) << process.said();
}

TEST_F(Restart, ASlideOnAClosedFormSampleGoesOnWithTheSameBits) {
  expect_same_after_stops("RI", {"--set", "stop.end_time=8 s", "--set", "coupling.time_step=1e-5 s"});
}

/// The sample with a cache of its own, in which it is prepared.
class RestartPreparation : public Restart {
 protected:
  RestartPreparation() { use_cache("whole_cache"); }
  void use_cache(const std::string& name) { ::setenv("FLOWSLIDE_CACHE", out(name).c_str(), 1); }
  std::vector<std::string> files(const std::string& cache, const std::string& part) const {
    std::vector<std::string> found;
    for (const auto& entry : std::filesystem::directory_iterator(out(cache)))
      if (const std::string name = entry.path().filename().string(); name.find(part) != name.npos)
        found.push_back(name);
    std::sort(found.begin(), found.end());
    return found;
  }
  const Words options_{"--engine", "native", "--point", "alone"};
};

TEST_F(RestartPreparation, GoesOnWithTheSameBits) {
  ASSERT_EQ(run("whole", options_), 0) << said_;
  use_cache("stopped_cache");
  int stops = 0, code = 0;
  for (double seconds = 0.05; (code = run_for(seconds, "stopped", options_)) == 75; seconds *= 1.3) {
    if (said_.find("its sample is being prepared; the same command continues the preparation") != said_.npos) ++stops;
    ASSERT_LT(seconds, 1000.0) << said_;
  }
  ASSERT_EQ(code, 0) << said_;
  EXPECT_GT(stops, 2);
  expect_same_files("alone", "stopped", "whole");
  EXPECT_EQ(files("stopped_cache", ".checkpoint_"), Words{});
  ASSERT_EQ(files("stopped_cache", ".h5"), files("whole_cache", ".h5"));
  for (const std::string& name : files("whole_cache", ".h5"))
    EXPECT_EQ(content_of(out("stopped_cache") / name), content_of(out("whole_cache") / name)) << name;
}

TEST_F(RestartPreparation, RemembersTrialsThatFailed) {
  // At sigma_0, grains that soft overlap by more than spheres may.
  Words options = options_;
  options.insert(options.end(), {"--set", "material.youngs_modulus=1 MPa", "--set", "sample.loose.most_trials=1"});
  EXPECT_EQ(run("out", options), 3);
  EXPECT_CONTAINS(said_, "trial 1: failed: ");
  ASSERT_NE(said_.rfind("flowslide: "), std::string::npos) << said_;
  const std::string end = said_.substr(said_.rfind("flowslide: "));
  EXPECT_EQ(files("whole_cache", ".failed").size(), 1U);
  EXPECT_EQ(files("whole_cache", ".h5"), Words{});
  EXPECT_EQ(run("out", options), 3);
  // At once: the reason again, and no step.
  EXPECT_CONTAINS(said_, "trial 1: failed: ");
  EXPECT_EQ(said_.find("steps"), said_.npos) << said_;
  EXPECT_EQ(said_.substr(said_.rfind("flowslide: ")), end);
}

TEST_F(Restart, EndsBeforeTheTimeThatItIsGiven) {
  const Words options{"--engine", "native", "--point", "RD"};
  ASSERT_EQ(run("whole", options), 0) << said_;
  int stops = 0, code = 0;
  for (double seconds = 0.01; seconds < 1000.0; seconds *= 1.5, ++stops) {
    if ((code = run_for(seconds, "limited", options)) != 75) break;
    EXPECT_CONTAINS(said_, "out of the time given by --max-walltime");
  }
  EXPECT_EQ(code, 0) << said_;
  EXPECT_GT(stops, 1);
  expect_same_files("RD", "limited", "whole");
  // The last start ran but a part.
  EXPECT_GT(provenance_of("limited", "RD").processor_seconds, 0.5 * provenance_of("whole", "RD").processor_seconds);
}

TEST_F(Restart, TellsHowFarItIsAndDrawsItSoFar) {
  const Words options{"--engine", "native", "--point", "RD", "--set", "stop.end_time=1e4 s"};  // outlasts the test
  const auto process = start("out", "RD", options);
  Words status = options;
  status.push_back("--status");
  ASSERT_EQ(run("out", status), 0) << said_;
  EXPECT_CONTAINS(said_, "RD     running");
  EXPECT_CONTAINS(said_, "m/s, sigma = ");
  Words so_far = options;
  so_far.push_back("--so-far");
  ASSERT_EQ(run("out", so_far), 0) << said_;
  EXPECT_CONTAINS(said_, "RD: so far at t = ");
  EXPECT_GT(read_result(out("out") / "so_far" / "RD.h5").series.rows(), 0U);
  EXPECT_EQ(run("out/so_far", {"--check"}), 2);
  EXPECT_CONTAINS(said_, "unfinished (--so-far)");
  EXPECT_TRUE(std::filesystem::exists(out("out") / "so_far" / "RD_over_time.dat"));

  // A second run of the same point is refused, and the first run is not disturbed.
  EXPECT_EQ(run("out", options), 2);
  EXPECT_CONTAINS(said_, "another process executes the run \"RD\" there");
  process->signal(SIGTERM);
  EXPECT_EQ(process->wait(), 75);
  ASSERT_EQ(run("out", status), 0);
  EXPECT_CONTAINS(said_, "RD     stopped");

  // A run with another configuration does not continue it either.
  EXPECT_EQ(run("out", {"--engine", "native", "--point", "RD", "--set", "stop.end_time=0.1 s"}), 2);
  EXPECT_CONTAINS(said_, "stop.end_time = \"10000.0 s\" there, \"0.1 s\" now");
}

TEST_F(Restart, BeginsAnewOnlyWhenTold) {
  const Words options{"--engine", "native", "--point", "alone"};
  EXPECT_EQ(run("nowhere", {"--engine", "native", "--point", "alone", "--resume"}), 2);
  EXPECT_CONTAINS(said_, "is not there: run the case first");
  EXPECT_FALSE(std::filesystem::exists(out("nowhere")));
  const auto process = start("out", "alone", options);
  process->signal(SIGTERM);
  ASSERT_EQ(process->wait(), 75) << process->said();
  Words afresh = options;
  afresh.push_back("--afresh");
  ASSERT_EQ(run("out", afresh), 0) << said_;
  EXPECT_EQ(said_.find("continues from"), std::string::npos) << said_;
}

TEST_F(Restart, UsesTheCheckpointBeforeADamagedOne) {
  const Words options{"--engine", "native", "--point", "RD"};
  ASSERT_EQ(run("whole", options), 0) << said_;
  const auto process = start("out", "RD", options);
  std::this_thread::sleep_for(std::chrono::milliseconds(60));
  process->signal(SIGTERM);
  ASSERT_EQ(process->wait(), 75) << process->said();
  const auto first = out("out") / ".flowslide" / "RD.checkpoint_0.h5";
  ASSERT_TRUE(std::filesystem::exists(first));
  std::filesystem::resize_file(first, std::filesystem::file_size(first) / 2);
  ASSERT_EQ(run("out", options), 0) << said_;
  EXPECT_CONTAINS(said_, first.string() + " is truncated");
  EXPECT_CONTAINS(said_, "continues from its checkpoint");
  expect_same_files("RD", "out", "whole");
}

}  // namespace
}  // namespace flowslide
