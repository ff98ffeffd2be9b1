// SPDX-License-Identifier: GPL-2.0-or-later
// Run in one process, and again on two MPI ranks (process.two_ranks).
#include "process/ranks.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <utility>

#include "dem/liggghts/instance.hpp"
#include "program/run_main.hpp"
#include "record/atomic_file.hpp"
#include "sample/failure.hpp"

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
    EXPECT_THROW(fail(), FirstRankFailed);
  EXPECT_TRUE(same_on_all_ranks(true));  // and none of them waits for ever
}

/// The exit code of a program whose first rank meets that failure, and what this rank says of it.
template <typename Exception>
std::pair<int, std::string> end_of(const Exception& failure) {
  testing::internal::CaptureStderr();
  const int code = run_main(
      [&]() -> int {
        on_first_rank([&] { throw failure; });
        return 0;
      },
      mpi_rank());
  return {code, testing::internal::GetCapturedStderr()};
}

TEST(Ranks, LetTheFirstAloneSayWhatFailed) {
  const auto [code, said] = end_of(ConfigurationError("no room on the disk"));
  EXPECT_EQ(said, mpi_rank() == 0 ? "flowslide: no room on the disk\n" : "");
  EXPECT_EQ(code, 2);
}

TEST(Ranks, ReturnTheCodeOfTheFirst) {
  EXPECT_EQ(end_of(FileError("a")).first, 2);
  EXPECT_EQ(end_of(NumericalFailure("a")).first, 3);
  EXPECT_EQ(end_of(std::logic_error("a")).first, 70);
  EXPECT_EQ(end_of(Stopped(ExitCode::resumable, "a")).first, 75);
  EXPECT_EQ(end_of(Stopped(ExitCode::interrupted, "a")).first, 130);
  EXPECT_EQ(end_of(42).first, 70);
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

}  // namespace
}  // namespace flowslide
