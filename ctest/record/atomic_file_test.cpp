// SPDX-License-Identifier: GPL-2.0-or-later
#include "record/atomic_file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <atomic>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "full_disk.hpp"
#include "temporary_folder.hpp"

namespace flowslide {
namespace {

std::string message_of(const auto& action) {
  try {
    action();
  } catch (const FileError& error) {
    return error.what();
  }
  return "no error";
}

TEST(WriteAtomically, WritesAnyBytesAndLeavesNothingElse) {
  const TemporaryFolder folder;
  const std::string content("a\0b\n\xff", 5);
  write_atomically(folder / "file", content);
  EXPECT_EQ(read_file(folder / "file"), content);
  write_atomically(folder / "empty", "");
  EXPECT_EQ(read_file(folder / "empty"), "");
  EXPECT_EQ(folder.entries(), 2);
}

TEST(WriteAtomically, ReplacesOrRefusesAsTold) {
  const TemporaryFolder folder;
  write_atomically(folder / "file", "old");
  const auto message = message_of([&] { write_atomically(folder / "file", "new", IfExists::refuse); });
  EXPECT_NE(message.find("exists already"), std::string::npos) << message;
  EXPECT_NE(message.find((folder / "file").string()), std::string::npos) << message;
  EXPECT_EQ(read_file(folder / "file"), "old");
  write_atomically(folder / "file", "new", IfExists::replace);
  EXPECT_EQ(read_file(folder / "file"), "new");
  write_atomically(folder / "second", "first try", IfExists::refuse);
  EXPECT_EQ(read_file(folder / "second"), "first try");
  EXPECT_EQ(folder.entries(), 2);
}

TEST(WriteAtomically, OnlyOneOfManyWritersSucceedsWhenRefusing) {
  const TemporaryFolder folder;
  std::atomic<int> succeeded{0};
  std::vector<std::jthread> writers;
  for (int i = 0; i < 8; ++i)
    writers.emplace_back([&, i] {
      if (message_of([&] { write_atomically(folder / "file", std::to_string(i), IfExists::refuse); }) == "no error")
        ++succeeded;
    });
  writers.clear();
  EXPECT_EQ(succeeded, 1);
  EXPECT_EQ(folder.entries(), 1);
}

TEST(WriteAtomically, FullDiskLeavesTheOldFileAndNothingNew) {
  const TemporaryFolder folder;
  write_atomically(folder / "file", "old");
  std::string message;
  {
    const FullDisk full(100);
    message = message_of([&] { write_atomically(folder / "file", std::string(1000, 'x')); });
  }
  EXPECT_NE(message.find("free some space"), std::string::npos) << message;
  EXPECT_EQ(read_file(folder / "file"), "old");
  EXPECT_EQ(folder.entries(), 1);
}

TEST(WriteAtomically, SaysWhatToDoAboutAMissingFolder) {
  const TemporaryFolder folder;
  const auto message = message_of([&] { write_atomically(folder / "none" / "file", "x"); });
  EXPECT_NE(message.find("create the folder"), std::string::npos) << message;
  EXPECT_EQ(folder.entries(), 0);
}

TEST(WriteAtomically, RefusesWhatIsNoRegularFile) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "folder");
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  for (const auto& path : {folder / "folder", folder / "pipe", std::filesystem::path("/dev/full"), folder / ""})
    EXPECT_THROW(write_atomically(path, "x"), FileError) << path;
  EXPECT_EQ(folder.entries(), 2);
}

TEST(WriteAtomically, GivesTheRightsOfAnyNewFile) {
  const TemporaryFolder folder;
  const mode_t before = ::umask(027);
  write_atomically(folder / "file", "x");
  ::umask(before);
  struct stat status {};
  ASSERT_EQ(::stat((folder / "file").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0640u);
}

TEST(ReadFile, RefusesWhatIsMissingOrNoFile) {
  const TemporaryFolder folder;
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  EXPECT_THROW(read_file(folder / "none"), FileError);
  EXPECT_THROW(read_file(folder.path()), FileError);
  EXPECT_THROW(read_file(folder / "pipe"), FileError);
}

}  // namespace
}  // namespace flowslide
