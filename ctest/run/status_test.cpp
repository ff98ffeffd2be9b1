// SPDX-License-Identifier: GPL-2.0-or-later
#include "run/status.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "record/damage.hpp"
#include "run/example_checkpoint.hpp"
#include "support/messages.hpp"

namespace flowslide {
namespace {

class StatusTest : public testing::Test {
 protected:
  StatusTest() {
    output_.note("RD", identity_.text());
    const FileLock lock = output_.lock_point("RD");
  }
  void keep() {
    Checkpoint checkpoint = example_checkpoint();
    identity_.stamp(checkpoint.partial_result);
    output_.checkpoints("RD").put([&](hdf5::Group& root) { write_checkpoint(root, checkpoint); });
  }
  PointStatus status_of(const std::string& point) const { return flowslide::status_of(output_, point, identity_); }
  PointStatus status_of_another_run() const {
    return flowslide::status_of(output_, "RD", {"fig12", "RD", {}, "seed = 8\n"});
  }
  const RunIdentity identity_{"fig12", "RD", {}, "seed = 7\n"};
  ScratchFolder scratch_;
  OutputFolder output_ = OutputFolder::open(scratch_.path() / "out", "fig12");
};

TEST_F(StatusTest, TellsWhatIsBegunAndWhatIsNot) {
  EXPECT_EQ(status_of("RI").state, "not begun");
  EXPECT_EQ(status_of("RD").state, "begun");
  EXPECT_EQ(status_of("RD").place, "");
}

TEST_F(StatusTest, TellsWhereAStoppedRunStands) {
  keep();
  const PointStatus status = status_of("RD");
  EXPECT_EQ(status.state, "stopped");
  EXPECT_EQ(status.share_done, 0.375);
  EXPECT_CONTAINS(status.place, "t = 0.3031 s, v = ");
  EXPECT_LT(status.age, 60.0);
  for (const int place : {0, 1}) overwrite(output_.checkpoints("RD").path(place), "x");
  EXPECT_EQ(status_of("RD").place, "its checkpoints are damaged");
}

TEST_F(StatusTest, TellsWhatRuns) {
  int ready[2], over[2];
  ASSERT_EQ(::pipe(ready) + ::pipe(over), 0);
  const pid_t other = ::fork();
  if (other == 0) {
    const int lock = ::open(output_.lock_path("RD").c_str(), O_RDWR);
    ::flock(lock, LOCK_EX);
    char byte = 0;
    if (::write(ready[1], &byte, 1) == 1 && ::read(over[0], &byte, 1) == 1) ::_exit(0);
    ::_exit(1);
  }
  char byte = 0;
  ASSERT_EQ(::read(ready[0], &byte, 1), 1);
  EXPECT_EQ(status_of("RD").state, "running");
  ASSERT_EQ(::write(over[1], &byte, 1), 1);
  ::waitpid(other, nullptr, 0);
  EXPECT_EQ(status_of("RD").state, "begun");
}

TEST_F(StatusTest, TellsWhatIsComplete) {
  Result result = example_result();
  identity_.stamp(result);
  write_result(output_.file("RD.h5"), result);
  EXPECT_EQ(status_of("RD").state, "complete");
  EXPECT_EQ(status_of("RD").share_done, 1.0);
  EXPECT_EQ(status_of("RD").sample, "");  // a result without one
  overwrite(output_.file("RD.h5"), "torn");
  EXPECT_EQ(status_of("RD").state, "damaged");
}

TEST_F(StatusTest, TellsWhatIsOfAnotherRun) {
  EXPECT_EQ(status_of_another_run().state, "not begun");
  keep();
  EXPECT_EQ(status_of_another_run().state, "outdated");
  EXPECT_EQ(status_of_another_run().place, "seed = 7 there, 8 now");
  Result result = example_result();
  identity_.stamp(result);
  write_result(output_.file("RD.h5"), result);
  EXPECT_EQ(status_of_another_run().state, "outdated");
  EXPECT_EQ(status_of_another_run().share_done, 0.0);
  EXPECT_EQ(status_of_another_run().place, "seed = 7 there, 8 now");
}

TEST_F(StatusTest, TellsTheHealthOfTheSample) {
  Result result = example_result();
  result.metrics = {{"initial_void_ratio", 0.7823, "1", ""},
                    {"initial_probe_void_ratio", 0.767, "1", ""},
                    {"mechanical_coordination_number", 4.6, "1", ""}};
  identity_.stamp(result);
  write_result(output_.file("RD.h5"), result);
  EXPECT_CONTAINS(status_of("RD").sample, "e0 0.7823 (probe 0.7670)");
}

TEST_F(StatusTest, IsPrintedForPeopleAndPrograms) {
  std::vector<PointStatus> points{{"RD", "running", "t = 0.5 s", 0.42, 12.0, ""},
                                  {"RI_long", "not begun", "", 0, 0, ""}};
  EXPECT_EQ(status_table(points),
            "run      state       done   kept before  at its last checkpoint\n"
            "RD       running     42 %          12 s  t = 0.5 s\n"
            "RI_long  not begun    0 %             -  -\n");
  const auto read = nlohmann::json::parse(status_json(points)).at("points");
  EXPECT_EQ(read.at(0), nlohmann::json({{"name", "RD"},
                                        {"state", "running"},
                                        {"share_done", 0.42},
                                        {"checkpoint_age", 12.0},
                                        {"place", "t = 0.5 s"},
                                        {"sample", ""}}));
  EXPECT_EQ(read.at(1).at("state"), "not begun");
  EXPECT_EQ(read.size(), 2U);
  points[0].sample = "e0 0.7823";
  EXPECT_CONTAINS(status_table(points), "\nsample of RD: e0 0.7823\n");
  EXPECT_CONTAINS(status_json(points), "\"sample\": \"e0 0.7823\"");
}

}  // namespace
}  // namespace flowslide
