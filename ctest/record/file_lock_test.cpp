// SPDX-License-Identifier: GPL-2.0-or-later
#include "record/file_lock.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "record/atomic_file.hpp"
#include "temporary_folder.hpp"

namespace flowslide {
namespace {

TEST(FileLock, IsHeldByOneAtATime) {
  const TemporaryFolder folder;
  {
    const auto held = FileLock::try_lock(folder / "lock");
    EXPECT_FALSE(FileLock::try_lock(folder / "lock"));
    EXPECT_TRUE(FileLock::try_lock(folder / "other"));
  }
  EXPECT_TRUE(FileLock::try_lock(folder / "lock"));
}

TEST(FileLock, StaysHeldWhenMoved) {
  const TemporaryFolder folder;
  auto first = FileLock::try_lock(folder / "lock");
  ASSERT_TRUE(first);
  auto second = std::make_unique<FileLock>(std::move(*first));
  EXPECT_FALSE(FileLock::try_lock(folder / "lock"));
  second.reset();
  EXPECT_TRUE(FileLock::try_lock(folder / "lock"));
}

TEST(FileLock, IsFreeOnceTheProcessThatHeldItHasEnded) {
  const TemporaryFolder folder;
  int ready[2];
  ASSERT_EQ(::pipe(ready), 0);
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    const auto held = FileLock::try_lock(folder / "lock");
    const auto told = ::write(ready[1], "x", 1);
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    ::_exit(told == 1 ? 0 : 1);  // without releasing the lock
  }
  char byte = 0;
  ASSERT_EQ(::read(ready[0], &byte, 1), 1);
  EXPECT_FALSE(FileLock::try_lock(folder / "lock"));
  int status = -1;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0);
  EXPECT_TRUE(FileLock::try_lock(folder / "lock"));
  ::close(ready[0]);
  ::close(ready[1]);
}

TEST(FileLock, RefusesAFolderThatIsNotThere) {
  const TemporaryFolder folder;
  EXPECT_THROW(FileLock::try_lock(folder / "none" / "lock"), FileError);
  std::filesystem::create_directory(folder / "lock");  // nor can a folder be locked
  EXPECT_THROW(FileLock::try_lock(folder / "lock"), FileError);
}

TEST(FileLock, TellsWhichProcessHoldsIt) {
  const TemporaryFolder folder;
  std::array<char, 256> machine{};
  ASSERT_EQ(::gethostname(machine.data(), machine.size() - 1), 0);
  const auto held = FileLock::try_lock(folder / "lock");
  EXPECT_EQ(FileLock::holder(folder / "lock"), "process " + std::to_string(::getpid()) + " on " + machine.data());
  {
    const auto again = FileLock::try_lock(folder / "lock");  // gets no lock, and so must not write its name
    EXPECT_FALSE(again);
  }
  EXPECT_EQ(FileLock::holder(folder / "lock"), "process " + std::to_string(::getpid()) + " on " + machine.data());
}

TEST(FileLock, DoesNotNameAHolderThatItDoesNotKnow) {
  const TemporaryFolder folder;
  EXPECT_EQ(FileLock::holder(folder / "none"), "another process");
  const pid_t gone = ::fork();
  if (gone == 0) {
    const auto held = FileLock::try_lock(folder / "lock");
    ::_exit(0);
  }
  ASSERT_EQ(::waitpid(gone, nullptr, 0), gone);
  EXPECT_EQ(FileLock::holder(folder / "lock"), "another process");  // it has ended: who has it now could not sign
  for (const char* text : {"", "x\n", "12", "-3 node\n", "12 \n", "99999999999999999999 node\n"}) {
    std::ofstream(folder / "lock") << text;
    EXPECT_EQ(FileLock::holder(folder / "lock"), "another process") << text;
  }
  std::ofstream(folder / "lock") << "12 another-machine\n";
  EXPECT_EQ(FileLock::holder(folder / "lock"), "process 12 on another-machine");
}

TEST(FileLock, HoldsWhatAnotherUserHasLeft) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root can be two users";
  const TemporaryFolder folder;
  EXPECT_TRUE(FileLock::try_lock(folder / "lock"));  // given up at once
  std::filesystem::permissions(folder.path(), std::filesystem::perms(0755));
  std::filesystem::permissions(folder / "lock", std::filesystem::perms(0644));
  ASSERT_EQ(::seteuid(65534), 0);
  std::optional<FileLock> held;
  EXPECT_NO_THROW(held = FileLock::try_lock(folder / "lock"));
  EXPECT_THROW(FileLock::try_lock(folder / "new"), FileError);
  ASSERT_EQ(::seteuid(0), 0);
  ASSERT_TRUE(held);
  EXPECT_TRUE(FileLock::is_held(folder / "lock"));
}

}  // namespace
}  // namespace flowslide
