// SPDX-License-Identifier: GPL-2.0-or-later
#include "process/exit_code.hpp"

#include <gtest/gtest.h>

namespace flowslide {
namespace {

TEST(ExitCodes, AreThoseThatScriptsKnow) {
  EXPECT_EQ(to_int(ExitCode::ok), 0);
  EXPECT_EQ(to_int(ExitCode::output), 1);
  EXPECT_EQ(to_int(ExitCode::configuration), 2);
  EXPECT_EQ(to_int(ExitCode::numerical_failure), 3);
  EXPECT_EQ(to_int(ExitCode::claim_not_met), 4);
  EXPECT_EQ(to_int(ExitCode::defect), 70);
  EXPECT_EQ(to_int(ExitCode::resumable), 75);
  EXPECT_EQ(to_int(ExitCode::interrupted), 130);
}

}  // namespace
}  // namespace flowslide
