// SPDX-License-Identifier: GPL-2.0-or-later
#include "experiment/windows.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "record/same_bits.hpp"

namespace flowslide::windows_test {
namespace {

constexpr double rounding = 1e-12;

WindowRecord record(double width) {
  return window_record({"x", "x", "m", "distance", "", {}}, {{"v", "v", "m/s", "velocity", "", {}}}, width);
}

/// v = 3 + 2 x, by points of this distance up to `end`.
WindowRecord line(double width, double distance, double end) {
  WindowRecord windows = record(width);
  for (int k = 0; k * distance < end + 0.5 * distance; ++k)
    windows.add(k * distance, std::array{3.0 + 2.0 * k * distance});
  return windows;
}

TEST(WindowEnd, DoublesItsWidthAndStaysAMultiple) {
  EXPECT_EQ(window_end(0.5, 1), 0.5);
  EXPECT_EQ(window_end(0.5, 1024), 512.0);
  EXPECT_EQ(window_end(0.5, 1025), 513.0);
  EXPECT_EQ(window_end(0.5, 1536), 1024.0);
  EXPECT_EQ(window_end(0.5, 1537), 1026.0);
  EXPECT_EQ(window_end(0.5, 1024 + 512 * 3), 4096.0);
}

TEST(WindowRecord, HasTheMeansOfALineWhateverPointsItIsGiven) {
  for (const double distance : {0.013, 0.1, 0.77}) {  // within windows, as wide as they, and across several
    const Series series = line(0.1, distance, 4.0).series();
    ASSERT_GE(series.rows(), 39U) << distance;
    for (std::size_t i = 0; i + 1 < series.rows(); ++i) {
      EXPECT_NEAR(series.axis.values[i], 0.1 * static_cast<double>(i + 1), rounding);
      EXPECT_NEAR(series.columns[0].values[i], 3.0 + 2.0 * (series.axis.values[i] - 0.05), 1e-10) << distance;
    }
  }
}

TEST(WindowRecord, EndsWithTheCurve) {
  const Series series = line(0.1, 0.05, 0.25).series();
  ASSERT_EQ(series.rows(), 3U);
  EXPECT_NEAR(series.axis.values.back(), 0.25, rounding);
  EXPECT_NEAR(series.columns[0].values.back(), 3.0 + 2.0 * 0.225, rounding);
  EXPECT_EQ(record(0.1).series().rows(), 0U);
}

TEST(WindowRecord, LeavesOutWhereTheAbscissaRunsBack) {
  WindowRecord windows = line(0.1, 0.01, 0.2);
  const Series before = windows.series();
  windows.add(0.1, std::array{1e9});
  windows.add(0.2, std::array{-1e9});
  windows.add(std::nan(""), std::array{1e9});
  windows.add(std::numeric_limits<double>::infinity(), std::array{1e9});
  expect_same_bits(windows.series(), before);
}

TEST(WindowRecord, GoesOnBitForBit) {
  const WindowRecord whole = line(0.03, 0.007, 5.0);
  WindowRecord kept = line(0.03, 0.007, 1.7);
  WindowRecord copy{kept};
  for (int k = 0; k * 0.007 < 5.0 + 0.5 * 0.007; ++k) copy.add(k * 0.007, std::array{3.0 + 2.0 * k * 0.007});
  expect_same_bits(copy.series(), whole.series());
}

TEST(WindowRecord, HasFewWindowsHoweverLongTheCurve) {
  WindowRecord windows = record(1e-3);
  windows.add(0.0, std::array{1.0});
  windows.add(1e6, std::array{1.0});  // one exchange of a slope in free fall
  EXPECT_LT(windows.means.rows(), 20000U);
  EXPECT_NEAR(mean_over(windows.series(), "v", 0.0, 1e6), 1.0, rounding);
}

TEST(MeanOver, CountsEachWindowByItsShare) {
  const Series series = line(0.1, 0.1, 1.0).series();
  EXPECT_NEAR(mean_over(series, "v", 0.2, 0.4), 3.6, rounding);
  // Halves of two windows with the means 3.5 and 3.7 and a whole one with 3.6... as steps, not as the line.
  EXPECT_NEAR(mean_over(series, "v", 0.25, 0.45), 0.25 * 3.5 + 0.5 * 3.7 + 0.25 * 3.9, rounding);
  EXPECT_NEAR(mean_over(series, "v", 0.9, 7.0), 4.9, rounding);  // up to its end
  EXPECT_NEAR(mean_over(series, "v", -1.0, 0.1), 3.1, rounding);
}

TEST(MeanOver, IsNoNumberWhereThereIsNothing) {
  const Series series = line(0.1, 0.1, 1.0).series();
  EXPECT_TRUE(std::isnan(mean_over(series, "v", 1.0, 2.0)));
  EXPECT_TRUE(std::isnan(mean_over(series, "other", 0.0, 1.0)));
  EXPECT_TRUE(std::isnan(mean_over(Series{}, "v", 0.0, 1.0)));
  EXPECT_EQ(end_of(Series{}), 0.0);
  EXPECT_NEAR(end_of(series), 1.0, rounding);
}

TEST(WindowsOfRows, AreThoseOfTheirCurve) {
  Series rows;
  rows.axis.values = {0.0, 0.1, 0.2, 0.3};
  rows.columns = {{"x", "x", "m", "distance", "", {0.0, 0.05, 0.1, 0.2}},
                  {"v", "v", "m/s", "velocity", "", {1.0, 1.0, 1.0, 3.0}}};
  const Series windows = windows_of_rows(rows, "x", {"v", "x", "other"}, 0.1);
  ASSERT_EQ(windows.columns.size(), 1U);
  EXPECT_EQ(windows.axis.name, "x");
  ASSERT_EQ(windows.rows(), 2U);
  EXPECT_NEAR(windows.column("v").values[0], 1.0, rounding);
  EXPECT_NEAR(windows.column("v").values[1], 2.0, rounding);
}

TEST(WindowsOver, AreThoseOfTheResultOrNone) {
  Result result;
  result.windows = {line(0.1, 0.1, 1.0).series()};
  EXPECT_EQ(windows_over(result, "x").rows(), 10U);
  EXPECT_EQ(windows_over(result, "time").rows(), 0U);
}

}  // namespace
}  // namespace flowslide::windows_test
