// SPDX-License-Identifier: GPL-2.0-or-later
#include "run/point_checkpoints.hpp"

#include <signal.h>

#include "process/exit_code.hpp"
#include "record/damage.hpp"
#include "record/full_disk.hpp"
#include "run/example_checkpoint.hpp"
#include "support/messages.hpp"

namespace flowslide {
namespace {

class PointCheckpointsTest : public testing::Test {
 protected:
  PointCheckpointsTest() {
    identity_.stamp(checkpoint_.partial_result);
    store_.put([&](hdf5::Group& root) { write_checkpoint(root, checkpoint_); });
  }
  PointCheckpoints open(const RunIdentity& identity) {
    testing::internal::CaptureStderr();
    std::optional<PointCheckpoints> made;
    try {
      made.emplace(CheckpointStore(scratch_.path(), "RD"), control_, identity);
    } catch (...) {
      said_ = testing::internal::GetCapturedStderr();
      throw;
    }
    said_ = testing::internal::GetCapturedStderr();
    return *std::move(made);
  }
  static RunIdentity of(const std::string& configuration) { return {"fig12_pulse", "RD", {}, configuration}; }

  ScratchFolder scratch_;
  Checkpoint checkpoint_ = example_checkpoint();
  const RunIdentity identity_ = of(checkpoint_.partial_result.configuration);
  CheckpointStore store_{scratch_.path(), "RD"};
  RunControl control_{{.checkpoint_interval = 0.0}};
  std::string said_;
};

TEST_F(PointCheckpointsTest, FindsWhatThereIsAndSaysSo) {
  const PointCheckpoints checkpoints = open(identity_);
  ASSERT_TRUE(checkpoints.found());
  EXPECT_EQ(checkpoints.found()->share_done, checkpoint_.share_done);
  EXPECT_CONTAINS(said_, "continues from its checkpoint at t = 0.3031 s, v = ");
  store_.remove();
  EXPECT_FALSE(open(of("anything")).found());
  EXPECT_EQ(said_, "");
}

TEST_F(PointCheckpointsTest, RefusesThatOfAnotherRunWithTheDifference) {
  const std::string message = message_of<Refused>([&] { open(of("[sample]\nseed = 8\n")); });
  EXPECT_CONTAINS(message, "is of another run (seed = 7 there, 8 now)");
  EXPECT_CONTAINS(message, "--afresh");
}

TEST_F(PointCheckpointsTest, UsesTheOneBeforeADamagedOneWithAWord) {
  store_.put([&](hdf5::Group& root) {
    Checkpoint later = checkpoint_;
    later.share_done = 0.5;
    write_checkpoint(root, later);
  });
  overwrite(store_.path(0), read_file(store_.path(0)).substr(0, 5000));
  EXPECT_EQ(open(identity_).found()->share_done, 0.375);
  EXPECT_CONTAINS(said_, store_.path(0).string() + " is truncated");
  EXPECT_CONTAINS(said_, "trying the checkpoint before it");
  overwrite(store_.path(1), "");
  EXPECT_CONTAINS(message_of<CorruptFileError>([&] { open(identity_); }), "--afresh");
}

TEST_F(PointCheckpointsTest, KeepsAndStops) {
  PointCheckpoints checkpoints = open(identity_);
  int asked = 0;
  const auto now = [&] {
    ++asked;
    Checkpoint later = checkpoint_;
    later.share_done = 0.5 + 0.1 * asked;
    return later;
  };
  checkpoints.poll(now);  // an interval of 0: at every checkpoint opportunity
  EXPECT_EQ(asked, 1);
  EXPECT_EQ(open(identity_).found()->share_done, 0.6);
  ::raise(SIGTERM);
  EXPECT_CONTAINS(message_of<Stopped>([&] { checkpoints.poll(now); }), "the same command continues from t = ");
  EXPECT_EQ(open(identity_).found()->share_done, 0.7);
}

TEST_F(PointCheckpointsTest, GoesOnWithoutACheckpointWhenTheDiskIsFull) {
  PointCheckpoints checkpoints = open(identity_);
  {
    const FullDisk full(1000);
    testing::internal::CaptureStderr();
    checkpoints.poll([&] { return checkpoint_; });
    EXPECT_CONTAINS(testing::internal::GetCapturedStderr(), "the checkpoint before is as it was");
    ::raise(SIGTERM);
    EXPECT_CONTAINS(message_of<FileError>([&] { checkpoints.poll([&] { return checkpoint_; }); }),
                    "the checkpoint before is as it was");
  }
  EXPECT_TRUE(open(identity_).found());
}

}  // namespace
}  // namespace flowslide
