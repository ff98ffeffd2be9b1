// SPDX-License-Identifier: GPL-2.0-or-later
#include "dem/make_engine.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <set>

#include "support/messages.hpp"

namespace flowslide {
namespace {

TEST(MakeEngine, MakesEveryEngineItNames) {
  for (const std::string& name : engine_names_of_build()) {
    const auto engine = make_engine(name, testing::TempDir() + "make_engine.log");
    EXPECT_EQ(engine->name(), name);
    EXPECT_FALSE(engine->version().empty());
  }
}

TEST(MakeEngine, VersionsNameTheSourcesAndThePrecision) {
  const auto version = [](const std::string& name) { return make_engine(name, "/dev/null")->version(); };
  std::set<std::string> versions;
  for (const std::string& name : engine_names_of_build()) {  // 16 digits of a hash
    EXPECT_TRUE(std::regex_search(version(name), std::regex("[0-9a-f]{16}"))) << version(name);
    versions.insert(version(name));
  }
  EXPECT_EQ(versions.size(), engine_names_of_build().size() > 2 ? 3U : 2U);  // the two of LIGGGHTS share one adapter
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

TEST(MakeEngine, SaysHowToGetAnEngineThatThisBuildHasNot) {
  const std::vector<std::string> built = engine_names_of_build();
  for (const std::string& name : engine_names()) {
    if (std::find(built.begin(), built.end(), name) != built.end()) continue;
    const auto complaint = message_of<MissingEngine>([&] { make_engine(name, "/dev/null"); });
    for (const char* part : {name.c_str(), "native, native-mixed", "libliggghts-dev", "-DFLOWSLIDE_LIGGGHTS=ON"})
      EXPECT_CONTAINS(complaint, part);
    EXPECT_EQ(message_of<MissingEngine>([&] { setup_text(name, {}, {}); }), complaint);
  }
}

TEST(MakeEngine, NativeEnginesTakeNoCommands) { EXPECT_TRUE(setup_text("native", {}, {}).empty()); }

}  // namespace
}  // namespace flowslide
