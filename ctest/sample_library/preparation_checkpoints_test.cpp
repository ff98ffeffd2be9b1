// SPDX-License-Identifier: GPL-2.0-or-later
#include "sample_library/preparation_checkpoints.hpp"

#include "record/damage.hpp"
#include "record/example.hpp"
#include "record/full_disk.hpp"
#include "record/same_bits.hpp"
#include "support/messages.hpp"

namespace flowslide {
namespace {

class PreparationCheckpointsTest : public testing::Test {
 protected:
  PreparationCheckpoints checkpoints(const std::string& key = "abc") const { return {scratch_.path(), key}; }
  std::filesystem::path file(int place) const { return CheckpointStore(scratch_.path(), "abc").path(place); }
  std::optional<PreparationState> find() {
    testing::internal::CaptureStderr();
    auto found = checkpoints().find();
    said_ = testing::internal::GetCapturedStderr();
    return found;
  }
  static PreparationState state(std::int64_t steps) {
    return {4, steps, 1200, 300, 9200, {28e3, -2.6e3, 0.1, 27e3, 29e3}, example_assembly()};
  }
  ScratchFolder scratch_;
  std::string said_;
};

TEST_F(PreparationCheckpointsTest, GivesBackEveryBit) {
  EXPECT_FALSE(find());
  auto kept = checkpoints();
  ASSERT_TRUE(kept.keep(state(2400)));
  ASSERT_TRUE(kept.keep(state(2430)));
  const auto found = find();
  ASSERT_TRUE(found);
  EXPECT_EQ(said_, "");
  EXPECT_EQ(found->stage, 4);
  EXPECT_EQ(found->steps, 2430);
  EXPECT_EQ(found->stage_start, 1200);
  EXPECT_EQ(found->within, 300);
  EXPECT_EQ(found->next_inspection, 9200);
  EXPECT_EQ(found->stress.normal, 28e3);
  EXPECT_EQ(found->stress.shear, -2.6e3);
  EXPECT_EQ(found->stress.transverse, 0.1);
  EXPECT_EQ(found->stress.lateral_x, 27e3);
  EXPECT_EQ(found->stress.lateral_y, 29e3);
  expect_same_bits(found->assembly, example_assembly());
  PreparationState mixing = state(2460);
  mixing.stage = 0;
  ASSERT_TRUE(kept.keep(mixing));
  EXPECT_EQ(find()->stage, 0);
  kept.remove();
  EXPECT_FALSE(find());
}

TEST_F(PreparationCheckpointsTest, BeginsAnewWhenAllIsDamagedAndSaysSo) {
  auto kept = checkpoints();
  kept.keep(state(2400));
  kept.keep(state(2430));
  const std::string whole = read_file(file(0));
  for (const std::string& bytes : damaged(whole)) {
    overwrite(file(0), bytes);
    const auto found = find();
    ASSERT_TRUE(found);
    EXPECT_EQ(found->steps, 2400);
    EXPECT_CONTAINS(said_, file(0).string());
  }
  overwrite(file(1), "");
  EXPECT_FALSE(find());
  EXPECT_CONTAINS(said_, "the preparation starts again");
}

TEST_F(PreparationCheckpointsTest, AreOfOneSample) {
  checkpoints("other").keep(state(2400));
  std::filesystem::rename(CheckpointStore(scratch_.path(), "other").path(1), file(1));
  EXPECT_FALSE(find());
  EXPECT_CONTAINS(said_, "is of another sample");
}

TEST_F(PreparationCheckpointsTest, SayThatTheDiskIsFull) {
  auto kept = checkpoints();
  ASSERT_TRUE(kept.keep(state(2400)));
  testing::internal::CaptureStderr();
  {
    const FullDisk full(1000);
    EXPECT_FALSE(kept.keep(state(2430)));
  }
  EXPECT_CONTAINS(testing::internal::GetCapturedStderr(), "free some space");
  EXPECT_EQ(find()->steps, 2400);
}

}  // namespace
}  // namespace flowslide
