// SPDX-License-Identifier: GPL-2.0-or-later
#include "dem/make_engine.hpp"

#include <gtest/gtest.h>

#include <regex>

namespace flowslide {
namespace {

TEST(MakeEngine, MakesEveryEngineItNames) {
  for (const std::string& name : engine_names()) {
    const auto engine = make_engine(name, testing::TempDir() + "make_engine.log");
    EXPECT_EQ(engine->name(), name);
    EXPECT_FALSE(engine->version().empty());
  }
}

TEST(MakeEngine, VersionsNameTheSourcesAndThePrecision) {
  const auto version = [](const std::string& name) { return make_engine(name, "/dev/null")->version(); };
  for (const std::string& name : engine_names())  // 16 digits of a hash
    EXPECT_TRUE(std::regex_search(version(name), std::regex("[0-9a-f]{16}"))) << version(name);
  EXPECT_NE(version("native"), version("native-mixed"));
  EXPECT_NE(version("native"), version("liggghts"));
}

TEST(MakeEngine, RefusesAnUnknownEngineAndSaysWhichThereAre) {
  try {
    make_engine("yade", "/dev/null");
    FAIL() << "there is an engine 'yade'";
  } catch (const std::invalid_argument& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("yade"), std::string::npos);
    EXPECT_NE(text.find("liggghts"), std::string::npos);
  }
}

}  // namespace
}  // namespace flowslide
