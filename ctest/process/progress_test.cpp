// SPDX-License-Identifier: GPL-2.0-or-later
#include "process/progress.hpp"

#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include "support/messages.hpp"

namespace flowslide {
namespace {

using namespace std::chrono_literals;

class ProgressOnAClock : public testing::Test {
 protected:
  ProgressStyle style(bool terminal) {
    ProgressStyle s;
    s.terminal = terminal;
    s.stream = &stream_;
    s.now = [this] { return now_; };
    return s;
  }
  std::string taken() {
    const std::string text = stream_.str();
    stream_.str("");
    return text;
  }
  std::ostringstream stream_;
  std::chrono::steady_clock::time_point now_{};
};

TEST_F(ProgressOnAClock, WritesALineEveryThirtySeconds) {
  Progress progress("fig03 loosest", 1000, style(false));
  now_ += 29s;
  progress.update(100, "strain 0.1");
  EXPECT_EQ(taken(), "");
  now_ += 1s;
  progress.update(300, "strain 0.3");
  EXPECT_EQ(taken(), "fig03 loosest:  30 %  10 steps/s  1 min 10 s left  strain 0.3\n");
  now_ += 10s;
  progress.update(310);
  EXPECT_EQ(taken(), "");
}

TEST_F(ProgressOnAClock, RewritesOneLineOnATerminal) {
  {
    Progress progress("a", 200000, style(true));
    now_ += 1s;
    progress.update(100000);
    EXPECT_EQ(taken(), "\ra:  50 %  100k steps/s  1 s left\x1b[K");
    now_ += 100ms;
    progress.update(110000);
    EXPECT_EQ(taken(), "");
    now_ += 100ms;
    progress.update(120000);
    EXPECT_EQ(taken(), "\ra:  60 %  100k steps/s  1 s left\x1b[K");
  }
  EXPECT_EQ(taken(), "\n");
}

TEST_F(ProgressOnAClock, NeverWrapsTheLineOnATerminal) {
  ProgressStyle narrow = style(true);
  narrow.columns = 10;
  Progress progress("ab\u00b5d", 10, narrow);
  progress.update(5, "a long text that does not fit");
  EXPECT_EQ(taken(), "\rab\u00b5d:  50\x1b[K");
}

TEST_F(ProgressOnAClock, CountsTimeLeftFromTheStepsOfThisRun) {
  Progress progress("a", 1000, style(false), 500);
  now_ += 100s;
  progress.update(600);
  EXPECT_EQ(taken(), "a:  60 %  1 steps/s  6 min 40 s left\n");
}

TEST_F(ProgressOnAClock, SaysNoSpeedBeforeTheFirstStep) {
  Progress progress("a", 1000, style(true), 0);
  progress.update(0);
  EXPECT_EQ(taken(), "\ra:   0 %\x1b[K");
}

TEST_F(ProgressOnAClock, SaysAHundredPerCentOnlyWhenAllIsDone) {
  Progress progress("a", 100000, style(true));
  now_ += 1s;
  progress.update(99999);
  EXPECT_CONTAINS(taken(), " 99 %");
}

TEST_F(ProgressOnAClock, FinishesOnceWithTheTimeTaken) {
  Progress progress("a", 2000, style(false));
  now_ += 75s;
  progress.update(2000);
  taken();
  progress.finish("done");
  progress.finish("again");
  progress.update(2000);
  EXPECT_EQ(taken(), "a: 100 %  2.00k steps in 1 min 15 s  done\n");
}

TEST_F(ProgressOnAClock, PutsMessagesOnLinesOfTheirOwn) {
  Progress progress("a", 10, style(true));
  progress.update(5);
  taken();
  progress.message("the sample is cached");
  EXPECT_EQ(taken(), "\r\x1b[Kthe sample is cached\n");
}

TEST_F(ProgressOnAClock, FollowsANewTotal) {
  Progress progress("a", 10, style(true));
  progress.set_total(20);
  progress.update(15);
  EXPECT_CONTAINS(taken(), " 75 %");
  EXPECT_THROW(progress.set_total(14), std::invalid_argument);
}

TEST_F(ProgressOnAClock, IsSilentWhenToldAndOnOtherRanks) {
  ProgressStyle silent = style(true);
  silent.silent = true;
  ProgressStyle other_rank = style(true);
  other_rank.rank = 1;
  for (const ProgressStyle& s : {silent, other_rank}) {
    Progress progress("a", 10, s);
    progress.update(5);
    progress.message("m");
    progress.finish();
  }
  EXPECT_EQ(taken(), "");
}

TEST_F(ProgressOnAClock, RefusesStepsOutsideTheTotal) {
  EXPECT_THROW(Progress("a", 10, style(false), 11), std::invalid_argument);
  EXPECT_THROW(Progress("a", -1, style(false)), std::invalid_argument);
  Progress progress("a", 10, style(false));
  EXPECT_THROW(progress.update(11), std::invalid_argument);
  EXPECT_THROW(progress.update(-1), std::invalid_argument);
}

TEST(DurationText, ReadsWell) {
  EXPECT_EQ(duration_text(0.2), "0 s");
  EXPECT_EQ(duration_text(59.4), "59 s");
  EXPECT_EQ(duration_text(59.6), "1 min 00 s");
  EXPECT_EQ(duration_text(3599.7), "1 h 00 min");
  EXPECT_EQ(duration_text(7620.0), "2 h 07 min");
  EXPECT_EQ(duration_text(353000.0), "4 d 02 h");
  EXPECT_EQ(duration_text(-1.0), "unknown");
  EXPECT_EQ(duration_text(std::numeric_limits<double>::infinity()), "unknown");
  EXPECT_EQ(duration_text(std::nan("")), "unknown");
}

TEST(CountText, KeepsThreeDigits) {
  EXPECT_EQ(count_text(0.5), "0.5");
  EXPECT_EQ(count_text(950), "950");
  EXPECT_EQ(count_text(12345), "12.3k");
  EXPECT_EQ(count_text(999499), "999k");
  EXPECT_EQ(count_text(4.56e6), "4.56M");
}

TEST(PredictionText, IsADurationThatIsNeverZero) {
  EXPECT_EQ(prediction_text(0.0), "below 1 s");
  EXPECT_EQ(prediction_text(0.49), "below 1 s");
  EXPECT_EQ(prediction_text(0.6), "1 s");
  EXPECT_EQ(prediction_text(185.0), duration_text(185.0));
  EXPECT_EQ(prediction_text(-1.0), "unknown");
}

}  // namespace
}  // namespace flowslide
