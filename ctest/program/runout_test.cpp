// SPDX-License-Identifier: GPL-2.0-or-later
#include "program/runout.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <map>

#include "experiment/slide_run.hpp"
#include "record/atomic_file.hpp"
#include "record/gnuplot_table.hpp"
#include "support/messages.hpp"

namespace flowslide {
namespace {

constexpr double rounding = 1e-12;

/// A slope that accelerates at 1 m/s^2 up to t = 1 s and is slowed down at 2 m/s^2 from then on, until `end`; tau falls
/// from 3 kPa to 100 Pa, and sigma lies at 20 Pa from 0.5 to 0.6 s.
Series slide(double end) {
  Series series = slide_series();
  for (int row = 0; row <= std::lround(end / 0.01); ++row) {
    const double t = 0.01 * row, late = std::max(t - 1.0, 0.0), early = std::min(t, 1.0);
    const double x = 0.5 * early * early + late - late * late;
    std::vector<double> values(series.columns.size(), 0.0);
    values[0] = x;
    values[1] = early - 2.0 * late;
    values[2] = x / 0.2;
    values[4] = x / 0.2 < 0.02 ? 3000.0 : 100.0;
    values[5] = t > 0.495 && t < 0.605 ? 20.0 : 1000.0;
    series.append_row(t, values);
  }
  return series;
}

std::map<std::string, double> metrics_of(double end, double duration, Stop stop, double sliding_velocity = 0.05) {
  SlidePoint point;
  point.stop.sliding_velocity = sliding_velocity;
  point.settings.loading = SinePulse{3e3, duration};
  const Series series = slide(end), profiles;
  std::map<std::string, double> values;
  const RunMeasures measures = measures_of_rows(series);
  for (const Metric& metric : pulse_runout({point, series, measures, profiles, stop}))
    values[metric.name] = metric.value;
  return values;
}

TEST(PulseRunout, MeasuresASlideThatGoesOn) {
  const auto metrics = metrics_of(1.2, 0.5, Stop::end_time);
  EXPECT_EQ(metrics.at("peak_shear_stress"), 3000.0);
  EXPECT_NEAR(metrics.at("lowest_normal_stress"), 20.0, 600.0 * rounding / 0.02);  // integrals of up to 600 Pa s
  EXPECT_NEAR(metrics.at("largest_velocity"), 0.5 * (0.975 + 0.95), rounding);  // 0.95 to 1.05 s
  EXPECT_NEAR(metrics.at("velocity_after_pulse"), 0.5, rounding);
  EXPECT_NEAR(metrics.at("runout"), 0.5 + 0.2 - 0.04, rounding);
  EXPECT_EQ(metrics.at("sliding_stopped"), 0.0);
  EXPECT_EQ(metrics.at("stands"), 0.0);
  EXPECT_NEAR(metrics.at("sliding_time"), 1.2, rounding);
}

TEST(PulseRunout, KnowsThatASlopeThatStoppedHasNoVelocity) {
  const auto stopped = metrics_of(1.5, 2.0, Stop::sliding_stopped);
  EXPECT_EQ(stopped.at("velocity_after_pulse"), 0.0);
  EXPECT_EQ(stopped.at("sliding_stopped"), 1.0);
  EXPECT_EQ(stopped.at("stands"), 1.0);
  EXPECT_EQ(metrics_of(1.2, 0.5, Stop::end_time, 2.0).at("stands"), 1.0);  // v stays below 2 m/s: never triggered
  EXPECT_TRUE(std::isnan(metrics_of(1.5, 2.0, Stop::end_time).at("velocity_after_pulse")));
}

TEST(PulseRunout, SaysOfAnyLoadingWhatItCan) {
  for (const StressHistory& loading :
       {StressHistory(NoChange{}), StressHistory(ConstantRate{1e4, 0.3}), StressHistory(StressTable{{0.0}, {3e3}})}) {
    SlidePoint point;
    point.settings.loading = loading;
    const Series series = slide(1.2), profiles;
    const RunMeasures measures = measures_of_rows(series);
    std::map<std::string, double> values;
    for (const Metric& metric : pulse_runout({point, series, measures, profiles, Stop::sliding_stopped}))
      values[metric.name] = metric.value;
    EXPECT_TRUE(std::isnan(values.at("velocity_after_pulse")));
    EXPECT_NEAR(values.at("largest_velocity"), 0.5 * (0.975 + 0.95), rounding);
    EXPECT_EQ(values.at("sliding_stopped"), 1.0);
  }
}

TEST(PulseRunout, TakesTheMeanOverAllOfARunThatIsShorterThanAWindow) {
  // The velocity grows from 0 to 0.05 m/s.
  EXPECT_NEAR(metrics_of(0.05, 2.0, Stop::end_time).at("largest_velocity"), 0.025, rounding);
  EXPECT_NEAR(metrics_of(0.1, 2.0, Stop::end_time).at("largest_velocity"), 0.05, rounding);
  SlidePoint point;
  const auto description = [&](double end) {
    const Series series = slide(end), profiles;
    const RunMeasures measures = measures_of_rows(series);
    return pulse_runout({point, series, measures, profiles, Stop::end_time}).at(2).long_name;
  };
  EXPECT_EQ(description(0.2), "largest sliding velocity, as a mean over 0.1 s");
  EXPECT_EQ(description(0.05),
            "largest sliding velocity, as a mean over all of the run, which is shorter than 0.1 s");
}

TEST(PulseRunout, LeavesOutWhatAShortRecordDoesNotHave) {
  const auto metrics = metrics_of(0.05, 2.0, Stop::end_time);
  EXPECT_TRUE(std::isnan(metrics.at("velocity_after_pulse")));
  EXPECT_NEAR(metrics.at("lowest_normal_stress"), 1000.0, 1e-9);
  EXPECT_EQ(metrics.at("peak_shear_stress"), 3000.0);
}

TEST(VelocityAt, NeedsAllOfItsWindow) {
  const Series over_time = measures_of_rows(slide(1.2)).over_time;
  EXPECT_NEAR(velocity_at(over_time, 0.5), 0.5, rounding);
  EXPECT_NEAR(velocity_at(over_time, 1.15), 0.7, rounding);
  EXPECT_TRUE(std::isnan(velocity_at(over_time, 1.16)));
  EXPECT_TRUE(std::isnan(velocity_at(over_time, 0.04)));
}

/// Runs with the parameter k.
Ensemble ensemble(double k, const std::vector<double>& values) {
  Ensemble all(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    all[i].metrics = {{"runout", values[i], "m", "sliding distance"}};
    all[i].parameters = {{"k", k, "m/s", "hydraulic conductivity"}};
  }
  return all;
}

TEST(Sweep, GoesByTheParametersNotByTheNames) {
  Ensembles slides{{"RI_1e-4", ensemble(1e-4, {1.0})},
                   {"RI_mine", ensemble(0.0, {3.0, 5.0, 4.0})},
                   {"RI_5", ensemble(2e-5, {2.0})},
                   {"RD_1", ensemble(1.0, {9.0})}};
  slides["RI_other"].emplace_back();  // without that parameter
  const auto sweep = sweep_of(slides, "RI_", "k");
  ASSERT_EQ(sweep.size(), 3U);
  EXPECT_EQ(sweep[0].parameter, 0.0);
  EXPECT_EQ(sweep[1].parameter, 2e-5);
  EXPECT_EQ(medians_along(sweep, "runout"), (std::vector<double>{4.0, 2.0, 1.0}));
  EXPECT_TRUE(std::isnan(medians_along(sweep, "other").front()));
}

TEST(Sweep, IsATableOfWhatAllSchemesHave) {
  const Ensembles slides{
      {"RI_1", ensemble(1.0, {3.0, 5.0, 4.0})}, {"RD_1", ensemble(1.0, {2.0})}, {"RD_2", ensemble(2.0, {9.0})}};
  const std::vector<std::pair<std::string, std::vector<SweepMember>>> schemes{{"RD", sweep_of(slides, "RD_", "k")},
                                                                              {"RI", sweep_of(slides, "RI_", "k")}};
  const Series series = sweep_series({"k", "k", "m/s", "", "", {}}, schemes, {"runout", "other"});
  EXPECT_EQ(series.axis.values, std::vector<double>{1.0});
  EXPECT_EQ(series.column("RD_runout_median").values, std::vector<double>{2.0});
  EXPECT_EQ(series.column("RI_runout_lowest").values, std::vector<double>{3.0});
  EXPECT_EQ(series.column("RI_runout_highest").values, std::vector<double>{5.0});
  EXPECT_EQ(series.column("RI_runout_median").units, "m");
  EXPECT_FALSE(series.has("RD_other_median"));  // no slide has it
  const Series none = sweep_series({"k", "k", "m/s", "", "", {}}, {{"RD", {}}, {"RI", {}}}, {"runout"});
  EXPECT_EQ(none.rows(), 0U);
  EXPECT_TRUE(none.has("RI_runout_median"));  // a figure finds its columns
}

TEST(Sweep, WritesTheTablesOfItsFigure) {
  const ScratchFolder scratch;
  const OutputFolder output = OutputFolder::open(scratch.path() / "out", "sweep");
  Ensembles slides{{"RI_1", ensemble(1.0, {3.0})}, {"RD_1", ensemble(1.0, {2.0})}, {"alone", ensemble(1.0, {2.0})}};
  for (const char* name : {"RI_1", "RD_1"}) {
    Series& rows = slides.at(name).front().series;
    rows.axis = {"time", "t", "s", "time", "", {0.0, 1.0}};
    rows.columns = {{"displacement", "x", "m", "sliding distance", "", {0.0, 2.0}}};
  }
  write_sweep(output, "sweep", slides,
              {{"k", "k", "m/s", "", "", {}}, {"runout"}, [](double k) { return fmt::format("k = {}", k); }});
  EXPECT_EQ(read_table(output.file("sweep.dat")).series.column("RI_runout_median").values, std::vector<double>{3.0});
  EXPECT_TRUE(std::filesystem::exists(output.file("RD_1_coarse.dat")));
  EXPECT_FALSE(std::filesystem::exists(output.file("alone_coarse.dat")));  // no slide
  EXPECT_CONTAINS(read_file(output.file("legend.txt")), "RD_1\tk = 1\n");
}

TEST(RankCorrelation, SeesOrderAlone) {
  EXPECT_NEAR(rank_correlation({0.0, 1.0, 10.0}, {5.0, 4.0, -3.0}), -1.0, rounding);
  // Spearman's 1 - 6 sum d^2/(n (n^2 - 1)), with two neighbours exchanged: sum d^2 = 2.
  EXPECT_NEAR(rank_correlation({1.0, 2.0, 3.0, 4.0}, {1.0, 3.0, 2.0, 4.0}), 1.0 - 12.0 / 60.0, rounding);
  EXPECT_TRUE(std::isnan(rank_correlation({1.0, 2.0}, {3.0, 3.0})));
}

TEST(RankCorrelation, IsNaNIfAValueIsNaN) {
  EXPECT_TRUE(std::isnan(rank_correlation({1.0, 2.0, 3.0}, {1.0, std::nan(""), 3.0})));
}

TEST(LabelOfQuantity, IsAPowerOfTen) {
  EXPECT_EQ(label_of_quantity(0.0), "0");
  EXPECT_EQ(label_of_quantity(1e-5), "10^{−5}");
  EXPECT_EQ(label_of_quantity(5e-6), "5×10^{−6}");
  EXPECT_EQ(label_of_quantity(2.5e3), "2.5×10^{3}");
}

TEST(RankCorrelation, SharesTheRanksOfEqualValues) {
  // Ranks 1, 2, 3 and 1.5, 1.5, 3: Pearson's of the ranks.
  EXPECT_NEAR(rank_correlation({1.0, 2.0, 3.0}, {0.0, 0.0, 7.0}), 1.5 / std::sqrt(2.0 * 1.5), rounding);
}

}  // namespace
}  // namespace flowslide
