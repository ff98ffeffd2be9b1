// SPDX-License-Identifier: GPL-2.0-or-later
#include "app/error.hpp"

#include <algorithm>
#include <new>

#include "messages.hpp"
#include "record/atomic_file.hpp"
#include "sample/failure.hpp"

namespace flowslide {
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

TEST(ExitCodes, AreThoseThatScriptsKnow) {
  EXPECT_EQ(to_int(ExitCode::ok), 0);
  EXPECT_EQ(to_int(ExitCode::configuration), 2);
  EXPECT_EQ(to_int(ExitCode::numerical_failure), 3);
  EXPECT_EQ(to_int(ExitCode::claim_not_met), 4);
  EXPECT_EQ(to_int(ExitCode::resumable), 75);
  EXPECT_EQ(to_int(ExitCode::interrupted), 130);
}

TEST(RunMain, PassesTheResultOnInSilence) {
  const Outcome outcome = outcome_of([] { return to_int(ExitCode::claim_not_met); });
  EXPECT_EQ(outcome.code, 4);
  EXPECT_EQ(outcome.error, "");
}

TEST(RunMain, EndsWithTwoForBadInput) {
  EXPECT_EQ(outcome_of_throwing(ConfigurationError("a")).code, 2);
  EXPECT_EQ(outcome_of_throwing(FileError("a")).code, 2);
  EXPECT_EQ(outcome_of_throwing(std::invalid_argument("a")).code, 2);
  EXPECT_EQ(outcome_of_throwing(std::domain_error("a")).code, 2);
  EXPECT_EQ(outcome_of_throwing(std::filesystem::filesystem_error("a", std::error_code())).code, 2);
}

TEST(RunMain, EndsWithThreeForEverythingElse) {
  EXPECT_EQ(outcome_of_throwing(NumericalFailure("a")).code, 3);
  EXPECT_EQ(outcome_of_throwing(std::runtime_error("a")).code, 3);
  EXPECT_EQ(outcome_of_throwing(std::out_of_range("a")).code, 3);
  EXPECT_EQ(outcome_of_throwing(std::bad_alloc()).code, 3);
  EXPECT_EQ(outcome_of_throwing(42).code, 3);
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
}  // namespace flowslide
