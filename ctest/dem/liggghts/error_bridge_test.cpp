// SPDX-License-Identifier: GPL-2.0-or-later
#include "dem/liggghts/error_bridge.hpp"

#include <gtest/gtest.h>

#include "dem/engine.hpp"
#include "dem/liggghts/instance.hpp"

namespace flowslide {
namespace {

std::string message_of(LiggghtsInstance& instance, const std::string& command) {
  try {
    instance.command(command);
  } catch (const EngineError& error) {
    return error.what();
  }
  return "";
}

TEST(ErrorBridge, AnErrorOfLiggghtsBecomesAnExceptionThatNamesCommandAndLog) {
  const std::string log = testing::TempDir() + "error_bridge.log";
  LiggghtsInstance instance(log);
  const std::string message = message_of(instance, "pair_style no_such_style 1 2 3");
  EXPECT_NE(message.find("pair_style no_such_style 1 2 3"), std::string::npos) << message;
  EXPECT_NE(message.find(log), std::string::npos) << message;
}

TEST(ErrorBridge, TheReasonThatLiggghtsGivesIsPassedOn) {
  LiggghtsInstance instance(testing::TempDir() + "error_bridge.log");
  EXPECT_NE(message_of(instance, "timestep").find("Illegal timestep command"), std::string::npos);
}

TEST(ErrorBridge, TheProcessGoesOnAfterwards) {
  { LiggghtsInstance broken(testing::TempDir() + "error_bridge.log"); message_of(broken, "unknown_command"); }
  LiggghtsInstance instance(testing::TempDir() + "error_bridge.log");
  EXPECT_EQ(message_of(instance, "units si"), "");
}

}  // namespace
}  // namespace flowslide
