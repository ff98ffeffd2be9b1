// SPDX-License-Identifier: GPL-2.0-or-later
#include "record/checkpoint_store.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <vector>

#include "damage.hpp"
#include "full_disk.hpp"
#include "temporary_folder.hpp"

namespace flowslide {
namespace {

class CheckpointStoreTest : public testing::Test {
 protected:
  void put(CheckpointStore& store, double value) {
    store.put([&](hdf5::Group& root) { root.write("value", value); });
  }
  /// The value that is read, and its number.
  double read(const CheckpointStore& store) {
    complaints_.clear();
    value_ = -1.0;
    number_ = store.read_newest([&](const hdf5::Group& root) { value_ = root.read_number("value"); },
                                [&](std::string_view word) { complaints_.emplace_back(word); });
    return value_;
  }
  TemporaryFolder folder_;
  double value_ = 0.0;
  std::int64_t number_ = 0;
  std::vector<std::string> complaints_;
};

TEST_F(CheckpointStoreTest, KeepsTheLastTwo) {
  CheckpointStore store(folder_.path(), "RD");
  EXPECT_TRUE(store.empty());
  EXPECT_EQ(read(store), -1.0);
  EXPECT_EQ(number_, 0);
  for (int i = 1; i <= 5; ++i) {
    put(store, i);
    EXPECT_EQ(read(CheckpointStore(folder_.path(), "RD")), i);
    EXPECT_EQ(number_, i);
  }
  EXPECT_EQ(folder_.entries(), 2U);
  EXPECT_FALSE(store.empty());
  EXPECT_TRUE(store.last_write().has_value());
  store.remove();
  EXPECT_EQ(folder_.entries(), 0U);
}

TEST_F(CheckpointStoreTest, AnotherProcessGoesOnCounting) {
  for (int i = 1; i <= 3; ++i) {
    CheckpointStore store(folder_.path(), "RD");
    put(store, i);
  }
  EXPECT_EQ(read(CheckpointStore(folder_.path(), "RD")), 3.0);
  EXPECT_EQ(number_, 3);
}

TEST_F(CheckpointStoreTest, UsesTheOneBeforeWhereTheNewestIsDamaged) {
  CheckpointStore store(folder_.path(), "RD");
  put(store, 1.0);
  put(store, 2.0);
  const auto newest = store.path(0);
  const std::string whole = read_file(newest);
  for (const std::string& bytes : damaged(whole)) {
    overwrite(newest, bytes);
    ASSERT_EQ(read(store), 1.0);
    ASSERT_EQ(complaints_.size(), 1U);
    EXPECT_NE(complaints_.front().find(newest.string()), std::string::npos) << complaints_.front();
  }
  // The next checkpoint replaces the damaged one, not the one that was used.
  CheckpointStore later(folder_.path(), "RD");
  put(later, 3.0);
  EXPECT_EQ(read(later), 3.0);
  EXPECT_EQ(number_, 2);
  EXPECT_TRUE(complaints_.empty());
}

TEST_F(CheckpointStoreTest, UsesTheOneBeforeWhereTheReaderCannotUseTheNewest) {
  CheckpointStore store(folder_.path(), "RD");
  put(store, 1.0);
  store.put([](hdf5::Group& root) { root.write("another", 2.0); });
  EXPECT_EQ(read(store), 1.0);
  EXPECT_EQ(complaints_.size(), 1U);
}

TEST_F(CheckpointStoreTest, SaysThatNoneCanBeUsed) {
  CheckpointStore store(folder_.path(), "RD");
  put(store, 1.0);
  put(store, 2.0);
  for (const int place : {0, 1}) overwrite(store.path(place), "torn");
  EXPECT_THROW(read(store), CorruptFileError);
  EXPECT_EQ(complaints_.size(), 2U);
}

TEST_F(CheckpointStoreTest, AFullDiskLeavesBothAsTheyWere) {
  CheckpointStore store(folder_.path(), "RD");
  put(store, 1.0);
  put(store, 2.0);
  {
    const FullDisk full(100);
    EXPECT_THROW(put(store, 3.0), FileError);
  }
  EXPECT_EQ(folder_.entries(), 2U);
  EXPECT_EQ(read(store), 2.0);
  EXPECT_TRUE(complaints_.empty());
  put(store, 3.0);
  EXPECT_EQ(read(store), 3.0);
}

}  // namespace
}  // namespace flowslide
