// SPDX-License-Identifier: GPL-2.0-or-later
#include "program/run_main.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <new>
#include <optional>
#include <system_error>

#include "configuration/error.hpp"
#include "dem/make_engine.hpp"
#include "process/mpi_session.hpp"
#include "process/ranks.hpp"
#include "record/atomic_file.hpp"
#include "sample/failure.hpp"
#include "support/messages.hpp"

namespace flowslide::run_main_test {
namespace {

struct Outcome {
  int code = -1;
  std::string error;
  std::string output;
};

Outcome outcome_of(const std::function<int()>& body, int rank = 0) {
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  Outcome outcome;
  outcome.code = run_main(body, rank);
  outcome.output = testing::internal::GetCapturedStdout();
  outcome.error = testing::internal::GetCapturedStderr();
  return outcome;
}

template <typename Exception>
Outcome outcome_of_throwing(const Exception& exception, int rank = 0) {
  return outcome_of([&]() -> int { throw exception; }, rank);
}

TEST(RunMain, PassesTheResultOnInSilence) {
  const Outcome outcome = outcome_of([] { return to_int(ExitCode::claim_not_met); });
  EXPECT_EQ(outcome.code, 4);
  EXPECT_EQ(outcome.error, "");
}

TEST(RunMain, KeepsTheMessageOfALaterRankForTheEnd) {
  testing::internal::CaptureStderr();
  std::string unsaid;
  EXPECT_EQ(run_main([]() -> int { throw FileError("no such file"); }, 1, &unsaid), 2);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(unsaid, "no such file");
}

TEST(RunMain, EndsWithTwoForWhatTheUserWroteOrTheMachineRefuses) {
  EXPECT_EQ(outcome_of_throwing(ConfigurationError("a")).code, 2);
  EXPECT_EQ(outcome_of_throwing(Refused("a")).code, 2);
  EXPECT_EQ(outcome_of_throwing(FileError("a")).code, 2);
  EXPECT_EQ(outcome_of_throwing(CorruptFileError("a")).code, 2);
  EXPECT_EQ(outcome_of_throwing(MissingEngine("a")).code, 2);
  EXPECT_EQ(outcome_of_throwing(std::filesystem::filesystem_error("a", std::error_code())).code, 2);
  EXPECT_EQ(
      outcome_of_throwing(std::system_error(std::make_error_code(std::errc::resource_unavailable_try_again))).code, 2);
}

TEST(RunMain, EndsWithThreeForWhatTheNumbersDid) {
  EXPECT_EQ(outcome_of_throwing(NumericalFailure("a")).code, 3);
  EXPECT_EQ(outcome_of_throwing(EngineError("a")).code, 3);
  EXPECT_EQ(outcome_of_throwing(std::bad_alloc()).code, 3);
}

TEST(RunMain, EndsWithSeventyForADefectOfItsOwn) {
  EXPECT_EQ(outcome_of_throwing(std::invalid_argument("a")).code, 70);
  EXPECT_EQ(outcome_of_throwing(std::domain_error("a")).code, 70);
  EXPECT_EQ(outcome_of_throwing(std::out_of_range("a")).code, 70);
  EXPECT_EQ(outcome_of_throwing(std::logic_error("a")).code, 70);
  EXPECT_EQ(outcome_of_throwing(std::bad_optional_access()).code, 70);
  EXPECT_EQ(outcome_of_throwing(std::runtime_error("a")).code, 70);
  EXPECT_EQ(outcome_of_throwing(42).code, 70);
  const std::string said = outcome_of_throwing(std::out_of_range("no column 'x'")).error;
  EXPECT_EQ(said,
            "flowslide: this is a defect of the program, not of your input: no column 'x'; please report it with "
            "the whole command, its configuration files and what --version prints\n");
}

TEST(RunMain, LeavesTheMessageOfTheFirstRankToIt) {
  const Outcome outcome = outcome_of_throwing(FirstRankFailed(), 1);
  EXPECT_NE(outcome.code, 0);  // see RunMainRanks for the code of the program
  EXPECT_EQ(outcome.error, "");
}

/// The exit code of a program whose first rank has this failure, and the message of this rank.
template <typename Exception>
Outcome end_of(const Exception& failure) {
  Outcome outcome = outcome_of(
      [&]() -> int {
        on_first_rank([&] { throw failure; });
        return 0;
      },
      mpi_rank());
  outcome.code = same_exit_code(outcome.code);
  return outcome;
}

TEST(RunMainRanks, LetTheFirstAloneSayWhatFailed) {
  const Outcome outcome = end_of(ConfigurationError("no room on the disk"));
  EXPECT_EQ(outcome.error, mpi_rank() == 0 ? "flowslide: no room on the disk\n" : "");
  EXPECT_EQ(outcome.code, 2);
}

TEST(RunMainRanks, ReturnTheCodeOfTheFirst) {
  EXPECT_EQ(end_of(FileError("a")).code, 2);
  EXPECT_EQ(end_of(NumericalFailure("a")).code, 3);
  EXPECT_EQ(end_of(std::logic_error("a")).code, 70);
  EXPECT_EQ(end_of(Stopped(ExitCode::resumable, "a")).code, 75);
  EXPECT_EQ(end_of(Stopped(ExitCode::interrupted, "a")).code, 130);
  EXPECT_EQ(end_of(42).code, 70);
}

/// Ends the process as a program ends whose standard output goes to `file`.
[[noreturn]] void end_with_output_to(const char* file, const std::function<int()>& body, int rank = 0) {
  if (std::freopen(file, "w", stdout) == nullptr) std::_Exit(99);
  std::_Exit(run_main(body, rank));
}

TEST(StandardOutputDeathTest, ThatIsFullIsAnErrorHoweverItIsWritten) {
  constexpr const char* full = "standard output cannot be written: No space left on device; what was printed is not";
  const std::string much(100000, 'x');
  for (const int code : {0, 4}) {
    EXPECT_EXIT(end_with_output_to("/dev/full", [&] { return std::cout << "a", code; }), testing::ExitedWithCode(1),
                full);
    EXPECT_EXIT(end_with_output_to("/dev/full", [&] { return std::cout << much, code; }), testing::ExitedWithCode(1),
                "standard output cannot be written");
    EXPECT_EXIT(end_with_output_to("/dev/full", [&] { return std::fputs("a", stdout), code; }),
                testing::ExitedWithCode(1), full);
  }
  EXPECT_EXIT(end_with_output_to("/dev/full", []() -> int { throw FinishedEarly("help"); }), testing::ExitedWithCode(1),
              full);
}

TEST(StandardOutputDeathTest, MattersOnlyWhereItIsUsed) {
  EXPECT_EXIT(end_with_output_to("/dev/full", [] { return 0; }), testing::ExitedWithCode(0), "");
  EXPECT_EXIT(end_with_output_to("/dev/full", [] { return std::cout << "a", 3; }), testing::ExitedWithCode(3), "");
  EXPECT_EXIT(end_with_output_to("/dev/null", [] { return std::cout << "a", 4; }), testing::ExitedWithCode(4), "");
  EXPECT_EXIT(end_with_output_to(
                  "/dev/full", []() -> int { throw FinishedEarly("help"); }, 1),
              testing::ExitedWithCode(0), "");  // another rank prints nothing
}

TEST(RunMain, PrintsExactlyOneMessage) {
  EXPECT_EQ(outcome_of_throwing(ConfigurationError("case.toml:1:2: no")).error, "flowslide: case.toml:1:2: no\n");
  EXPECT_EQ(outcome_of_throwing(std::bad_alloc()).error,
            "flowslide: out of memory: use fewer grains or a larger machine\n");
  EXPECT_NE(outcome_of_throwing(42).error, "");
}

TEST(RunMain, PrintsHelpToStandardOutputAndSucceeds) {
  const Outcome outcome = outcome_of_throwing(FinishedEarly("the help\n"));
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.output, "the help\n");
  EXPECT_EQ(outcome.error, "");
}

TEST(RunMain, LetsOneRankSpeakForAllAboutInput) {
  EXPECT_EQ(outcome_of_throwing(ConfigurationError("a"), 1).error, "");
  EXPECT_EQ(outcome_of_throwing(ConfigurationError("a"), 1).code, 2);
  EXPECT_EQ(outcome_of_throwing(FinishedEarly("help"), 1).output, "");
  EXPECT_EQ(outcome_of_throwing(NumericalFailure("a grain left the cell"), 1).error,
            "flowslide: rank 1: a grain left the cell\n");
}

}  // namespace
}  // namespace flowslide::run_main_test
