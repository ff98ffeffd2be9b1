// SPDX-License-Identifier: GPL-2.0-or-later
#include "dem/make_engine.hpp"

#include <gtest/gtest.h>

namespace flowslide {
namespace {

TEST(MakeEngine, MakesEveryEngineItNames) {
  for (const std::string& name : engine_names()) {
    const auto engine = make_engine(name, testing::TempDir() + "make_engine.log");
    EXPECT_EQ(engine->name(), name);
    EXPECT_FALSE(engine->version().empty());
  }
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
