// SPDX-License-Identifier: GPL-2.0-or-later
#include "experiment/ensemble.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace flowslide {
namespace {

constexpr double rounding = 1e-13;

/// x = rate t and tau = level + slope x at t = 0, 0.1, ... 1.
Result line(double rate, double level, double slope = 0.0) {
  Result result;
  result.series.columns = {{"x", "x", "m", "distance", "", {}}, {"tau", "tau", "Pa", "stress", "", {}}};
  for (int row = 0; row <= 10; ++row) {
    const double time = 0.1 * row;
    result.series.append_row(time, std::array{rate * time, level + slope * rate * time});
  }
  return result;
}

const Column& column(const Series& series, const std::string& name) { return series.column(name); }

TEST(Ensemble, HasTheStatisticsOfItsValues) {
  const Statistics all = statistics_of({4.0, 1.0, 2.0, 9.0});
  EXPECT_EQ(all.median, 3.0);
  EXPECT_EQ(all.mean, 4.0);
  EXPECT_EQ(all.lowest, 1.0);
  EXPECT_EQ(all.highest, 9.0);
  EXPECT_NEAR(all.deviation, std::sqrt(38.0 / 3.0), rounding);
  EXPECT_NEAR(all.standard_error, std::sqrt(38.0 / 12.0), rounding);
  EXPECT_EQ(statistics_of({7.0, 5.0, 6.0}).median, 6.0);
  EXPECT_EQ(statistics_of({7.0}).standard_error, 0.0);
  EXPECT_TRUE(std::isnan(statistics_of({}).median));
  EXPECT_TRUE(std::isnan(statistics_of({1.0, std::nan(""), 2.0}).lowest));
}

TEST(Ensemble, SumsUpMetricsThatAllReplicatesHave) {
  Result first, second;
  first.metrics = {{"peak", 3.0, "Pa", ""}, {"regain", 1.0, "Pa", ""}};
  second.metrics = {{"peak", 5.0, "Pa", ""}};
  const auto summary = summary_of({first, second});
  EXPECT_EQ(summary.at("peak.median"), 4.0);
  EXPECT_EQ(summary.at("peak.highest"), 5.0);
  EXPECT_NEAR(summary.at("peak.standard_error"), 1.0, rounding);
  EXPECT_FALSE(summary.contains("regain.mean"));
  EXPECT_EQ(values_of({first, second}, "regain"), std::vector{1.0});
}

Result on_sample(int replicate, const std::string& sample, double peak = 0.0) {
  Result result;
  result.provenance.replicate = replicate;
  result.provenance.sample = sample;
  result.metrics = {{"peak", peak, "Pa", ""}};
  return result;
}

TEST(Ensemble, PairsResultsOnOneSampleWhateverTheirOrder) {
  const Ensemble rd{on_sample(0, "loose a", 1.0), on_sample(1, "loose b", 2.0)};
  const Ensemble ri{on_sample(2, "loose c", 30.0), on_sample(0, "loose a", 10.0)};  // one was not run, one is another's
  const auto values = paired_values(paired(rd, ri), "peak");
  EXPECT_EQ(values, (std::vector<std::pair<double, double>>{{1.0, 10.0}}));
}

TEST(Ensemble, ComparesRunsSampleBySample) {
  Result without = on_sample(2, "loose c");
  without.metrics.clear();
  const Ensemble rd{on_sample(0, "loose a", 11.0), on_sample(1, "loose b", 600.0), on_sample(3, "loose d", 9e9)};
  const Ensemble ri{on_sample(1, "loose b", 300.0), on_sample(0, "loose a", 10.0), without};
  const Statistics difference = paired_difference(rd, ri, "peak"), ratio = paired_ratio(rd, ri, "peak");
  EXPECT_NEAR(difference.mean, 150.5, rounding);
  EXPECT_NEAR(difference.standard_error, 149.5, rounding);  // half the difference of the two differences
  EXPECT_NEAR(ratio.median, 1.55, rounding);
  EXPECT_TRUE(std::isnan(paired_difference(rd, {without}, "peak").mean));
}

TEST(Ensemble, PairsNoTwoSamplesOfOneTable) {
  EXPECT_TRUE(paired({on_sample(0, "loose a")}, {on_sample(0, "loose b")}).empty());
  // Samples of two tables have seeds of one number.
  EXPECT_EQ(paired({on_sample(0, "loose a")}, {on_sample(0, "large b")}).size(), 1U);
  EXPECT_EQ(paired({on_sample(3, "loose")}, {on_sample(3, "loose")}).size(), 1U);  // not made of grains
}

TEST(Ensemble, HasTheParametersOfItsRuns) {
  Result result;
  result.parameters = {{"hydraulic_conductivity", 2e-5, "m/s", ""}};
  EXPECT_EQ(parameter_of({result}, "hydraulic_conductivity"), 2e-5);
  EXPECT_TRUE(std::isnan(parameter_of({result}, "amplitude")));
}

TEST(Ensemble, AveragesOverAnAbscissaByTrapezoids) {
  const Series series = line(2.0, 1.0, 3.0).series;
  EXPECT_NEAR(mean_between(series, "tau", "x", 0.25, 0.75), 1.0 + 3.0 * 0.5, rounding);
  EXPECT_NEAR(mean_between(series, "tau", "time", 0.5, 9.0), 1.0 + 3.0 * 1.5, rounding);  // up to its end
  EXPECT_TRUE(std::isnan(mean_between(series, "tau", "x", 2.5, 3.0)));
}

TEST(Ensemble, LeavesOutWhereTheAbscissaRunsBack) {
  Result result = line(1.0, 5.0);
  result.series.columns[0].values = {0.0, 0.1, 0.2, 0.3, 0.2, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6};
  for (int row = 4; row <= 7; ++row) result.series.columns[1].values[row] = 1e6;
  EXPECT_NEAR(mean_between(result.series, "tau", "x", 0.0, 0.6), 5.0, rounding);
}

TEST(Ensemble, HasABandOverTheRangeThatAllCover) {
  const Series band = band_over({line(1.0, 1.0), line(2.0, 5.0), line(3.0, 2.0)}, "x", 4);
  EXPECT_EQ(band.axis.name, "x");
  ASSERT_EQ(band.rows(), 4U);
  EXPECT_NEAR(band.axis.values[0], 0.125, rounding);
  EXPECT_NEAR(band.axis.values[3], 0.875, rounding);
  EXPECT_NEAR(column(band, "tau_median").values[2], 2.0, rounding);
  EXPECT_NEAR(column(band, "tau_lowest").values[2], 1.0, rounding);
  EXPECT_NEAR(column(band, "tau_highest").values[2], 5.0, rounding);
  EXPECT_NEAR(column(band, "time_median").values[3], 0.875 / 2.0, rounding);
  EXPECT_EQ(band.columns.front().name, "time_median");
  EXPECT_NO_THROW(band.check());
  const Series none = band_over({line(0.0, 1.0), line(2.0, 5.0)}, "x", 4);
  EXPECT_EQ(none.rows(), 0U);
  EXPECT_TRUE(none.has("tau_median"));  // a figure finds its columns, without rows
  Result empty = line(1.0, 1.0);
  empty.series.axis.values.clear();
  for (Column& column : empty.series.columns) column.values.clear();
  EXPECT_EQ(band_over({empty}, "x", 4).rows(), 0U);
}

TEST(Ensemble, HasABandAsFarAsMostReplicatesReach) {
  const Ensemble three{line(1.0, 1.0), line(2.0, 5.0), line(4.0, 2.0)};   // ends and values of tau
  const Series band = band_over(three, "x", 4, BandEnd::most);
  EXPECT_NEAR(band.axis.values[3], 1.75, rounding);   // the second ends at 2
  EXPECT_NEAR(column(band, "tau_median").values[1], 2.0, rounding);
  EXPECT_NEAR(column(band, "tau_lowest").values[1], 1.0, rounding);
  EXPECT_NEAR(column(band, "tau_lowest").values[2], 2.0, rounding);   // without the first
  EXPECT_NEAR(column(band, "tau_median").values[2], 3.5, rounding);
  EXPECT_NEAR(band_over({three[0], three[2]}, "x", 1, BandEnd::most).axis.values[0], 0.5, rounding);   // both reach 1
}

TEST(Ensemble, HasABandRowByRow) {
  Series first{{"z", "z", "1", "height", "", {0.0, 1.0}}, {{"v", "v", "1", "velocity", "", {1.0, 2.0}}}};
  Series second = first;
  second.columns[0].values = {3.0, 0.0};
  first.columns.push_back({"late", "v", "1", "velocity", "", {1.0, 2.0}});
  const Series band = band_of_rows({first, second});
  ASSERT_EQ(band.columns.size(), 3U);
  EXPECT_EQ(column(band, "v_median").values, (std::vector{2.0, 1.0}));
  EXPECT_EQ(column(band, "v_lowest").values, (std::vector{1.0, 0.0}));
}

}  // namespace
}  // namespace flowslide
