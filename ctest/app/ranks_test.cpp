// SPDX-License-Identifier: GPL-2.0-or-later
// Run in one process, and again on two MPI ranks (app.two_ranks).
#include "app/ranks.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "app/error.hpp"
#include "dem/liggghts/instance.hpp"

namespace flowslide {
namespace {

TEST(Ranks, AgreeOnWhatTheFirstSays) {
  EXPECT_TRUE(same_on_all_ranks(mpi_rank() == 0));
  EXPECT_FALSE(same_on_all_ranks(mpi_rank() != 0));
}

TEST(Ranks, AgreeWithoutAnotherUseOfMpiBefore) {
  // In a process of its own, as ctest runs it, this is the first call of all: MPI must be started by it.
  EXPECT_TRUE(same_on_all_ranks(true));
}

TEST(Ranks, ActOnTheFirstAlone) {
  int acted = 0;
  on_first_rank([&] { ++acted; });
  EXPECT_EQ(acted, mpi_rank() == 0 ? 1 : 0);
}

TEST(Ranks, WaitForTheFirst) {
  // What the first rank notes in its action, the others may rely on afterwards.
  bool noted = false;
  on_first_rank([&] { noted = true; });
  EXPECT_TRUE(same_on_all_ranks(noted));
}

TEST(Ranks, FailTogether) {
  const auto fail = [] { on_first_rank([] { throw std::domain_error("no room on the disk"); }); };
  if (mpi_rank() == 0)
    EXPECT_THROW(fail(), std::domain_error);
  else
    EXPECT_THROW(fail(), ConfigurationError);
  EXPECT_TRUE(same_on_all_ranks(true));  // and none of them waits for ever
}

TEST(Ranks, LetTheFirstAloneSayWhatFailed) {
  testing::internal::CaptureStderr();
  const int code = run_main(
      []() -> int {
        on_first_rank([] { throw ConfigurationError("no room on the disk"); });
        return 0;
      },
      mpi_rank());
  EXPECT_EQ(testing::internal::GetCapturedStderr(), mpi_rank() == 0 ? "flowslide: no room on the disk\n" : "");
  EXPECT_EQ(code, 2);
}

}  // namespace
}  // namespace flowslide
