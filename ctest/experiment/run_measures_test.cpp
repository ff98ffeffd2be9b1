// SPDX-License-Identifier: GPL-2.0-or-later
#include "experiment/run_measures.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "experiment/shear_test.hpp"
#include "experiment/slide_run.hpp"
#include "record/same_bits.hpp"
#include "sample/critical_state_sample.hpp"
#include "sample/elastic_sample.hpp"

namespace flowslide {
namespace {

SlideSettings pulsed() {
  SlideSettings settings;
  settings.time_step = 1e-4;
  settings.loading = SinePulse{9e3, 0.4};
  settings.rate = GlobalRate{};
  settings.passing = {CarryRemainder{10}, 1e-5, 100000};
  return settings;
}

CriticalStateSample loose() {
  CriticalStateProperties properties;
  properties.shear_stress = initial_shear_stress({});
  properties.normal_stress = initial_normal_stress({});
  return CriticalStateSample(properties);
}

/// A slide with rows of a given spacing, and the measures gathered during it.
SlideRecord slide(const RowSpacing& spacing, double mean_stress_interval = 5e-4) {
  CriticalStateSample sample = loose();
  Slide slide(pulsed(), sample);
  SlideRecord record{.spacing = spacing};
  record.exchanges = ExchangeRecord(record.grains, mean_stress_interval);
  run_slide(slide, {0.6}, record);
  return record;
}

void expect_same(const RunMeasures& a, const RunMeasures& b) {
  expect_same_bits(a.over_time, b.over_time);
  expect_same_bits(a.over_strain, b.over_strain);
  expect_same_bits(a.over_displacement, b.over_displacement);
  for (const auto& [one, other] : {std::pair{a.peak_to_2, b.peak_to_2}, std::pair{a.peak_to_5, b.peak_to_5}}) {
    EXPECT_EQ(one.stress, other.stress);
    EXPECT_EQ(one.normal, other.normal);
    EXPECT_EQ(one.strain, other.strain);
    EXPECT_EQ(one.time, other.time);
    EXPECT_EQ(one.largest_number, other.largest_number);
  }
  EXPECT_EQ(a.lowest_normal_stress, b.lowest_normal_stress);
}

TEST(ExchangeRecord, IsTheSameToTheBitWhateverRowsAreKept) {
  const RunMeasures fine = slide({.interval = 1e-4, .most_rows = 100000}).exchanges.measures();
  for (const RowSpacing& spacing : {RowSpacing{.interval = 10.0}, RowSpacing{.interval = 3e-3, .most_rows = 12},
                                    RowSpacing{.strain = 1e-3, .most_rows = 50}})
    expect_same(fine, slide(spacing).exchanges.measures());
  EXPECT_GT(fine.peak_to_2.stress, fine.over_time.column("shear_stress").values.front());
  EXPECT_GT(end_of(fine.over_strain), 0.1);  // it slides
}

TEST(ExchangeRecord, FindsThePeakThatFineRowsShow) {
  const SlideRecord fine = slide({.interval = 1e-4, .most_rows = 100000});
  const Series& rows = fine.series;
  std::size_t top = 0;
  for (std::size_t row = 0; row < rows.rows() && rows.column("shear_strain").values[row] <= 0.02; ++row)
    if (rows.column("shear_stress").values[row] > rows.column("shear_stress").values[top]) top = row;
  const StressPeak peak = slide({.interval = 10.0}).exchanges.measures().peak_to_2;
  EXPECT_EQ(peak.stress, rows.column("shear_stress").values[top]);
  EXPECT_EQ(peak.normal, rows.column("normal_stress").values[top]);
  EXPECT_EQ(peak.strain, rows.column("shear_strain").values[top]);
  EXPECT_EQ(peak.time, rows.axis.values[top]);
}

TEST(ExchangeRecord, HasTheWindowsThatFineRowsHave) {
  const SlideRecord fine = slide({.interval = 1e-4, .most_rows = 100000});
  const RunMeasures gathered = fine.exchanges.measures(), of_rows = measures_of_rows(fine.series);
  for (const char* name : {"velocity", "shear_stress", "normal_stress"})
    for (std::size_t i = 0; i < of_rows.over_time.rows(); ++i)
      ASSERT_DOUBLE_EQ(gathered.over_time.column(name).values[i], of_rows.over_time.column(name).values[i]);
  ASSERT_EQ(gathered.over_strain.rows(), of_rows.over_strain.rows());
  EXPECT_EQ(gathered.lowest_normal_stress, of_rows.lowest_normal_stress);
  EXPECT_EQ(gathered.peak_to_5.stress, of_rows.peak_to_5.stress);
}

/// Of an elastic sample tau = tau_0 + G gamma, whatever portions its strain comes in: the stress that the slope holds
/// in between would lag by some hundred Pa here.
TEST(ExchangeRecord, HasTheLineOfAnElasticSampleHoweverStrainIsAccumulated) {
  constexpr double modulus = 0.5e6, until = 4e-3;  // Pa, strain
  ElasticProperties properties;
  properties.shear_modulus = modulus;
  properties.viscosity = 0.0;
  properties.shear_stress = initial_shear_stress({});
  properties.normal_stress = initial_normal_stress({});
  ElasticSample sample(properties);
  SlideSettings settings = pulsed();
  settings.passing = {CarryRemainder{1000}, 1e-5, 100000};
  Slide slide(settings, sample);
  SlideRecord record{.spacing = {.interval = 1.0}};
  run_slide(slide, {.end_time = 0.6, .end_shear_strain = 2.0 * until}, record);
  const Series& over_strain = record.exchanges.measures().over_strain;
  ASSERT_GT(end_of(over_strain), until);
  // Less than a local step of strain is carried over: at rates below 1 1/s that is dt_L times 1 1/s.
  const double owed = modulus * settings.passing.time_step * 1.0;
  for (double from = 1e-3; from < until; from += 5e-4)
    EXPECT_NEAR(mean_over(over_strain, "shear_stress", from, from + 5e-4),
                properties.shear_stress + modulus * (from + 2.5e-4), owed)
        << from;
}

TEST(ExchangeRecord, HasInertialNumbersOfThoseWhoAskForThem) {
  EXPECT_FALSE(slide({.interval = 0.1}, INFINITY).exchanges.measures().over_strain.has("global_inertial_number"));
  const RunMeasures measures = slide({.interval = 0.1}).exchanges.measures();
  EXPECT_GT(mean_over(measures.over_strain, "global_inertial_number", 0.0, 0.1), 0.0);
  EXPECT_GT(measures.peak_to_5.largest_number, 0.0);
}

TEST(ExchangeRecord, GoesOnBitForBit) {
  const RunMeasures whole = slide({.interval = 0.01}).exchanges.measures();
  CriticalStateSample sample = loose();
  Slide slide(pulsed(), sample);
  SlideRecord record{.spacing = {.interval = 0.01}};
  record.exchanges = ExchangeRecord(record.grains, 5e-4);
  for (int stops = 0; stops < 5; ++stops) {
    int steps = 0;
    run_slide(slide, {0.6}, record, [&](const SlideState&) { return ++steps < 777; });
    ExchangeRecord fresh(record.grains, 5e-4);
    fresh.restore(record.exchanges);
    record.exchanges = fresh;
  }
  run_slide(slide, {0.6}, record);
  expect_same(record.exchanges.measures(), whole);
}

TEST(ExchangeRecord, RefusesWindowsOfAnotherSlide) {
  ExchangeRecord record({}, 5e-4);
  EXPECT_THROW(record.restore(ExchangeRecord()), std::invalid_argument);  // one without inertial numbers
  ExchangeRecord wide({}, 5e-4);
  wide.over_time.width *= 2.0;
  EXPECT_THROW(record.restore(wide), std::invalid_argument);
}

TEST(ExchangeRecord, LooksForPeaksUpToTheirStrainAlone) {
  ExchangeRecord record;
  record.take_peaks(0.0, 0.0, {1.0, 9.0}, 0.5);
  record.take_peaks(0.1, 0.01, {3.0, 8.0}, 0.1);
  record.take_peaks(0.2, 0.03, {5.0, 7.0}, 0.7);
  record.take_peaks(0.3, 0.01, {9.0, 6.0}, 0.8);  // it has swung back: the strain of 2 % is behind it
  record.take_peaks(0.4, 0.06, {11.0, 5.0}, 0.9);
  record.take_peaks(0.5, 0.7, {1.0, 1.0}, 0.9);
  const RunMeasures measures = record.measures();
  EXPECT_EQ(measures.peak_to_2.stress, 3.0);
  EXPECT_EQ(measures.peak_to_2.largest_number, 0.5);
  EXPECT_EQ(measures.peak_to_5.stress, 9.0);
  EXPECT_EQ(measures.peak_to_5.time, 0.3);
  EXPECT_EQ(measures.peak_to_5.largest_number, 0.8);
  EXPECT_EQ(measures.lowest_normal_stress, 5.0);  // up to 50 %
}

TEST(RunMeasures, OfAnElementTestAreWindowsOverItsStrain) {
  Series rows = shear_test_series();
  for (int row = 0; row <= 10; ++row) {
    std::vector<double> values(rows.columns.size(), 0.0);
    values[0] = 1e-3 * row;
    values[1] = 100.0 * row;
    rows.append_row(0.1 * row, values);
  }
  const RunMeasures measures = measures_of_rows(rows);
  EXPECT_NEAR(mean_over(measures.over_strain, "shear_stress", 0.0, 0.01), 500.0, 1e-9);
  EXPECT_TRUE(measures.over_displacement.columns.empty());
  EXPECT_EQ(measures.peak_to_2.strain, 0.01);
  EXPECT_EQ(measures.windows().size(), 2U);  // over time and strain
}

}  // namespace
}  // namespace flowslide
