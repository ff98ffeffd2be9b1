// SPDX-License-Identifier: GPL-2.0-or-later
// Run in one process, and again on two MPI ranks (process.two_ranks).
#include "process/ranks.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "process/exit_code.hpp"
#include "process/mpi_session.hpp"

namespace flowslide {
namespace {

TEST(Ranks, AgreeOnWhatTheFirstSays) {
  EXPECT_TRUE(same_on_all_ranks(mpi_rank() == 0));
  EXPECT_FALSE(same_on_all_ranks(mpi_rank() != 0));
}

TEST(Ranks, AgreeWithoutAnotherUseOfMpiBefore) {
  // ctest runs each test in its own process. This is the first call, and it must start MPI.
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
    EXPECT_THROW(fail(), FirstRankFailed);
  EXPECT_TRUE(same_on_all_ranks(true));  // and no rank waits for ever
}

TEST(Ranks, ReturnTheCodeOfTheOneThatFailed) {
  const bool first = mpi_rank() == 0, last = mpi_rank() == mpi_ranks() - 1;
  EXPECT_EQ(same_exit_code(0), 0);
  EXPECT_EQ(same_exit_code(first ? 4 : 0), 4);
  EXPECT_EQ(same_exit_code(last ? 3 : 0), 3);
  EXPECT_EQ(same_exit_code(last ? 70 : 4), 70);
  EXPECT_EQ(same_exit_code(first ? 75 : 2), 75);  // of several, that of the first that failed
  EXPECT_EQ(same_exit_code(last ? 130 : 0), 130);
}

TEST(Ranks, SayWhatOneOfThemKeptToItselfIfItsCodeIsTheCommonOne) {
  const bool last = mpi_rank() == mpi_ranks() - 1;
  testing::internal::CaptureStderr();
  same_exit_code(last ? 2 : 0, last && mpi_rank() > 0 ? "no such file" : "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), last && mpi_rank() > 0 ? "flowslide: rank 1: no such file\n" : "");
  testing::internal::CaptureStderr();
  same_exit_code(2, mpi_rank() > 0 ? "no such file" : "");  // the first rank has the same failure and has said it
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace flowslide
