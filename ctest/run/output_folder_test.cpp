// SPDX-License-Identifier: GPL-2.0-or-later
#include "run/output_folder.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <csignal>
#include <stdexcept>

#include "process/exit_code.hpp"
#include "support/messages.hpp"

namespace flowslide {
namespace {

namespace fs = std::filesystem;

std::string complaint(const fs::path& path, const std::string& case_name = "fig03") {
  return message_of<Refused>([&] { OutputFolder::open(path, case_name); });
}

std::size_t count_of(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST(OutputFolder, IsCreatedWithItsParentsAndMarked) {
  const ScratchFolder scratch;
  const auto folder = OutputFolder::open(scratch.path() / "a" / "b", "fig03");
  EXPECT_EQ(content_of(scratch.path() / "a" / "b" / ".flowslide" / "case"), "fig03\n");
  EXPECT_EQ(folder.file("x.h5"), scratch.path() / "a" / "b" / "x.h5");
}

TEST(OutputFolder, IsOpenedAgainWithItsFiles) {
  const ScratchFolder scratch;
  OutputFolder::open(scratch.path(), "fig03");
  scratch.write("loose.h5", "data");
  EXPECT_NO_THROW(OutputFolder::open(scratch.path(), "fig03"));
  EXPECT_EQ(content_of(scratch.path() / "loose.h5"), "data");
}

TEST(OutputFolder, RefusesFilesOfOthers) {
  const ScratchFolder scratch;
  scratch.write("thesis.tex", "years of work");
  EXPECT_EQ(complaint(scratch.path()), "the output folder " + scratch.path().string() +
                                           " holds files that this program did not write, such as thesis.tex; choose "
                                           "another with --output");
  EXPECT_EQ(count_of(scratch.path()), 1U);
}

TEST(OutputFolder, RefusesTheFolderOfAnotherCase) {
  const ScratchFolder scratch;
  OutputFolder::open(scratch.path(), "fig03");
  EXPECT_CONTAINS(complaint(scratch.path(), "fig08"), "holds results of the case \"fig03\", not of \"fig08\"");
  EXPECT_EQ(content_of(scratch.path() / ".flowslide" / "case"), "fig03\n");
}

TEST(OutputFolder, RefusesAFileAndAPathBelowAFile) {
  const ScratchFolder scratch;
  const fs::path file = scratch.write("file", "text");
  EXPECT_CONTAINS(complaint(file), "is a file, not a folder");
  EXPECT_CONTAINS(complaint(file / "below"), "choose another with --output");
  EXPECT_EQ(content_of(file), "text");
}

TEST(OutputFolder, RefusesWhatCannotBeWritten) {
  EXPECT_CONTAINS(complaint("/proc/flowslide"), "the output folder /proc/flowslide cannot be written");
  EXPECT_CONTAINS(complaint("/proc"), "choose another with --output");
}

TEST(OutputFolder, IsOnlyReadForCheck) {
  const ScratchFolder scratch;
  const auto message = [&](const fs::path& path, const std::string& name) {
    return message_of<Refused>([&] { OutputFolder::open_existing(path, name); });
  };
  EXPECT_CONTAINS(message(scratch.path() / "none", "fig03"), "is not there: run the case first");
  EXPECT_FALSE(fs::exists(scratch.path() / "none"));
  EXPECT_CONTAINS(message(scratch.path(), "fig03"), "holds no results of the case \"fig03\"");
  EXPECT_EQ(count_of(scratch.path()), 0U);
  OutputFolder::open(scratch.path(), "fig03");
  EXPECT_NO_THROW(OutputFolder::open_existing(scratch.path(), "fig03"));
  EXPECT_CONTAINS(message(scratch.path(), "fig08"), "holds results of the case \"fig03\"");
}

TEST(OutputFolder, NotesTheIdentityOfAPoint) {
  const ScratchFolder scratch;
  const auto folder = OutputFolder::open(scratch.path(), "fig03");
  EXPECT_EQ(folder.noted("loose"), "");
  folder.note("loose", "mu = 1\n");
  folder.note("dense", "mu = 2\n");
  EXPECT_EQ(OutputFolder::open(scratch.path(), "fig03").noted("loose"), "mu = 1\n");
}

TEST(OutputFolder, HasResultsThatAreThereAndNotLeftOut) {
  const ScratchFolder scratch;
  auto folder = OutputFolder::open(scratch.path(), "fig03");
  EXPECT_FALSE(folder.has_result("loose"));
  scratch.write("loose.h5", "data");
  EXPECT_TRUE(folder.has_result("loose"));
  folder.leave_out("loose");
  EXPECT_FALSE(folder.has_result("loose"));
}

TEST(OutputFolder, RemovesAllFilesOfAPointAndNoOther) {
  const ScratchFolder scratch;
  const auto folder = OutputFolder::open(scratch.path(), "fig03");
  folder.note("e0_0", "mu = 1\n");
  fs::create_directory(folder.file("e0_0_frames"));
  for (const char* name : {"e0_0.h5", "e0_0.dat", "e0_0_profiles.dat", "e0_0_details.dat", "e0_0.md", "e0_0.pvd",
                           "e0_0_frames/grains_0.vtp", ".flowslide/e0_0.checkpoint_1.h5"})
    scratch.write(name, "text");
  const auto others = {"e0_0.5.h5", "e0_0_r2.h5", "e0_0_over_time.dat", ".flowslide/e0_0.5.checkpoint_1.h5"};
  for (const char* name : others) scratch.write(name, "text");
  folder.remove_point("e0_0");
  for (const char* name : others) EXPECT_TRUE(fs::exists(folder.file(name))) << name;
  EXPECT_EQ(folder.noted("e0_0"), "");
  EXPECT_EQ(count_of(scratch.path()), 4U);                 // three of the others, and the mark
  EXPECT_EQ(count_of(scratch.path() / ".flowslide"), 2U);  // the last of them, and the case
}

TEST(OutputFolder, RefusesPointNamesThatLeaveTheFolder) {
  const ScratchFolder scratch;
  const auto folder = OutputFolder::open(scratch.path() / "a", "fig03");
  for (const std::string name : {"", "../../x", "a/b", "a b"})
    EXPECT_THROW({ const FileLock lock = folder.lock_point(name); }, std::invalid_argument) << name;
  EXPECT_FALSE(fs::exists(scratch.path() / "x.hash"));
}

TEST(OutputFolder, LetsOneProcessRunAPoint) {
  const ScratchFolder scratch;
  const auto folder = OutputFolder::open(scratch.path(), "fig03");
  {
    const FileLock held = folder.lock_point("loose");
    EXPECT_CONTAINS(message_of<Refused>([&] { const FileLock lock = folder.lock_point("loose"); }),
                    "is in use: another process executes the run \"loose\" there");
    EXPECT_NO_THROW({ const FileLock lock = folder.lock_point("dense"); });
  }
  EXPECT_NO_THROW({ const FileLock lock = folder.lock_point("loose"); });
}

TEST(OutputFolder, RemovesWhatAKilledProcessLeftOfThatPoint) {
  const ScratchFolder scratch;
  const auto folder = OutputFolder::open(scratch.path(), "fig03");
  for (const char* name : {".loose.h5.12.0.partial", ".loose_profiles.dat.12.0.partial", ".loose_r2.h5.12.0.partial",
                           ".flowslide/.loose.checkpoint_0.h5.12.0.partial"})
    scratch.write(name, "half");
  const FileLock lock = folder.lock_point("loose");
  EXPECT_FALSE(fs::exists(folder.file(".loose.h5.12.0.partial")));
  EXPECT_FALSE(fs::exists(folder.file(".loose_profiles.dat.12.0.partial")));
  EXPECT_FALSE(fs::exists(folder.file(".flowslide/.loose.checkpoint_0.h5.12.0.partial")));
  EXPECT_TRUE(fs::exists(folder.file(".loose_r2.h5.12.0.partial")));  // another point's, which may be running
}

}  // namespace
}  // namespace flowslide
