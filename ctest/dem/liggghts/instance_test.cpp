// SPDX-License-Identifier: GPL-2.0-or-later
#include "dem/liggghts/instance.hpp"

#include <gtest/gtest.h>
#include <lammps.h>
#include <update.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>

namespace flowslide {
namespace {

TEST(Instance, CommandsReachTheirOwnSimulation) {
  LiggghtsInstance one(testing::TempDir() + "one.log"), two(testing::TempDir() + "two.log");
  one.command("timestep 0.25");
  two.command("timestep 0.5");
  EXPECT_EQ(one->update->dt, 0.25);
  EXPECT_EQ(two->update->dt, 0.5);
}

TEST(Instance, AUsedInstanceComesBackClean) {
  const double fresh = LiggghtsInstance(testing::TempDir() + "one.log")->update->dt;
  { LiggghtsInstance used(testing::TempDir() + "one.log"); used.command("timestep 0.125"); }
  EXPECT_EQ(LiggghtsInstance(testing::TempDir() + "one.log")->update->dt, fresh);
}

TEST(Instance, WritesItsLogWhateverThePath) {
  for (const char* name : {"with blanks", "a \" quote", "both \" and '", "$HOME ${x} #1 &", "M\xC3\xBCller"}) {
    const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / name;
    std::filesystem::create_directories(folder);
    {
      LiggghtsInstance instance(folder / "a log.txt");
      instance.command("print \"here it is\"");
    }
    LiggghtsInstance other(testing::TempDir() + "one.log");  // takes the instance and closes the first log
    std::ifstream log(folder / "a log.txt");
    const std::string text(std::istreambuf_iterator<char>(log), {});
    EXPECT_NE(text.find("here it is"), std::string::npos) << name;
  }
}

TEST(Instance, SaysWhichLogCannotBeWritten) {
  try {
    LiggghtsInstance instance("/dev/null/no/log.txt");
    FAIL() << "a log below a file";
  } catch (const std::system_error& error) {   // a wrong path, not a numerical failure
    EXPECT_NE(std::string(error.what()).find("/dev/null/no/log.txt: Not a directory"), std::string::npos);
  }
  EXPECT_NO_THROW(LiggghtsInstance(testing::TempDir() + "one.log"));  // the instance is used again
}

}  // namespace
}  // namespace flowslide
