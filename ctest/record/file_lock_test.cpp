// SPDX-License-Identifier: GPL-2.0-or-later
#include "record/file_lock.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <memory>
#include <thread>
#include <utility>

#include "record/atomic_file.hpp"
#include "temporary_folder.hpp"

namespace flowslide {
namespace {

TEST(FileLock, IsHeldByOneAtATime) {
  const TemporaryFolder folder;
  {
    const FileLock held(folder / "lock");
    EXPECT_FALSE(FileLock::try_lock(folder / "lock"));
    EXPECT_TRUE(FileLock::try_lock(folder / "other"));
  }
  EXPECT_TRUE(FileLock::try_lock(folder / "lock"));
}

TEST(FileLock, StaysHeldWhenMoved) {
  const TemporaryFolder folder;
  FileLock first(folder / "lock");
  auto second = std::make_unique<FileLock>(std::move(first));
  EXPECT_FALSE(FileLock::try_lock(folder / "lock"));
  second.reset();
  EXPECT_TRUE(FileLock::try_lock(folder / "lock"));
}

TEST(FileLock, WaitsForAnotherProcessAndOutlivesItsDeath) {
  const TemporaryFolder folder;
  int ready[2];
  ASSERT_EQ(::pipe(ready), 0);
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    const FileLock held(folder / "lock");
    const auto told = ::write(ready[1], "x", 1);
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    ::_exit(told == 1 ? 0 : 1);  // without giving the lock back
  }
  char byte = 0;
  ASSERT_EQ(::read(ready[0], &byte, 1), 1);
  EXPECT_FALSE(FileLock::try_lock(folder / "lock"));
  const FileLock waited(folder / "lock");
  int status = -1;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0);
  ::close(ready[0]);
  ::close(ready[1]);
}

TEST(FileLock, RefusesAFolderThatIsNotThere) {
  const TemporaryFolder folder;
  EXPECT_THROW(FileLock lock(folder / "none" / "lock"), FileError);
}

}  // namespace
}  // namespace flowslide
