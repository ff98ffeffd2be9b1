// SPDX-License-Identifier: GPL-2.0-or-later
#include "trial.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "sample/failure.hpp"

namespace flowslide {
namespace {

Outcome outcome(const ReferenceValue& reference, double measured) {
  return attempt("a", reference, [=] { return measured; }).outcome;
}

Outcome outcome_of_error(const std::string& refusal, const std::string& message) {
  return attempt("a", {0.0, 0.0, 0.0, 0.0, refusal}, [&]() -> double { throw NumericalFailure(message); }).outcome;
}

TEST(Attempt, JudgesByTheReferenceValue) {
  const ReferenceValue reference = relative(-2.0, 0.1, 0.5);
  EXPECT_EQ(outcome(reference, -2.19), Outcome::accurate);
  EXPECT_EQ(outcome(reference, -1.81), Outcome::accurate);
  EXPECT_EQ(outcome(reference, -1.79), Outcome::stable);
  EXPECT_EQ(outcome(reference, -2.99), Outcome::stable);
  EXPECT_EQ(outcome(reference, -3.01), Outcome::silently_wrong);
  EXPECT_EQ(outcome(reference, 2.0), Outcome::silently_wrong);
}

TEST(Attempt, TakesWhatIsNoNumberForSilentlyWrong) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(outcome({0.0, infinity, -infinity, infinity}, nan), Outcome::silently_wrong);
  EXPECT_EQ(outcome(relative(1.0, 0.1, 0.5), infinity), Outcome::silently_wrong);
}

TEST(Attempt, TakesARefusalForTheExpectedReasonAlone) {
  EXPECT_EQ(outcome_of_error("too long", "the time step is too long"), Outcome::refused);
  EXPECT_EQ(outcome_of_error("too long", "the key x is missing"), Outcome::needless);
  EXPECT_EQ(outcome_of_error("", "the time step is too long"), Outcome::needless);
}

TEST(Attempt, LetsADefectOfTheCodePass) {
  EXPECT_THROW(attempt("a", {}, []() -> double { throw std::out_of_range("a defect"); }), std::out_of_range);
}

TEST(Verdict, NamesEveryOutcomeThatThereIs) {
  std::vector<SceneTrial> trials(2);
  trials[0].outcome = trials[1].outcome = Outcome::accurate;
  EXPECT_EQ(verdict_of(trials), "stable and accurate");
  trials.push_back(attempt("b", relative(1.0, 0.0, 0.5), [] { return 1.2; }));
  EXPECT_EQ(verdict_of(trials), "stable and accurate (2), stable (1)");
  trials.push_back(attempt("c", relative(1.0, 0.0, 0.5), [] { return 2.0; }));
  EXPECT_EQ(verdict_of(trials), "stable and accurate (2), stable (1), SILENTLY WRONG (1)");
}

TEST(Trials, BecomeASeriesAndRowsOfATable) {
  const std::vector<SceneTrial> trials{
      attempt("first", relative(1.0, 0.0, 0.5), [] { return 1.2; }),
      attempt("second", {0.0, 0.0, 0.0, 0.0, "no"}, []() -> double { throw std::invalid_argument("no | way\n"); })};
  const Series series = series_of(trials);
  EXPECT_EQ(series.column("measured").values, (std::vector<double>{1.2, 0.0}));
  EXPECT_EQ(series.column("outcome").values, (std::vector<double>{1.0, 2.0}));
  EXPECT_EQ(markdown_rows("s", trials),
            "| s | first | 1 ± 0 | 1.2 | stable |  |\n"
            "| s | second | 0 ± 0 | - | refused | no \\| way  |\n");
}

}  // namespace
}  // namespace flowslide
