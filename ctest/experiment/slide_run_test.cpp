// SPDX-License-Identifier: GPL-2.0-or-later
#include "experiment/slide_run.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "dem/make_engine.hpp"
#include "dem/native/native_engine.hpp"
#include "grains/measures.hpp"
#include "grains/profiles.hpp"
#include "process/mpi_session.hpp"
#include "sample/dem_sample.hpp"
#include "sample/elastic_sample.hpp"
#include "support/touching_lattice.hpp"

namespace flowslide::slide_run_test {
namespace {

SlideSettings pulsed() {
  SlideSettings settings;
  settings.time_step = 1e-3;
  settings.slope.hydraulic_conductivity = 1e-4;
  settings.loading = SinePulse{1e3, 0.5};
  settings.rate = GlobalRate{};
  settings.passing = {CarryRemainder{10}, 1e-5, 1000};
  return settings;
}

bool equal_on_all_ranks(double value) {
  std::array<double, 2> largest{value, -value};
  largest_over_ranks(largest);
  return largest[0] == value && largest[1] == -value;
}

ElasticSample elastic() {
  ElasticProperties properties;
  properties.shear_stress = initial_shear_stress({});
  properties.normal_stress = 0.97 * initial_normal_stress({});
  return ElasticSample(properties);
}

TEST(RunSlide, RecordsTheStateInEveryColumn) {
  ElasticSample sample = elastic();
  SlideSettings settings = pulsed();
  settings.residual = ResidualTreatment::left_out;
  Slide slide(settings, sample);
  SlideRecord record{.spacing = {.interval = 0.01}, .grains = {6e-3, 2650.0}};
  EXPECT_EQ(run_slide(slide, {0.1}, record), Stop::end_time);
  EXPECT_NO_THROW(record.series.check());
  const auto last = [&](const char* name) { return record.series.column(name).values.back(); };
  const SlideState& state = slide.state();
  EXPECT_EQ(last("displacement"), state.sliding.displacement);
  EXPECT_EQ(last("velocity"), state.velocity);
  EXPECT_EQ(last("shear_strain"), state.strain.shear);
  EXPECT_EQ(last("volumetric_strain"), state.strain.compression);
  EXPECT_EQ(last("shear_stress"), state.stress.shear);
  EXPECT_EQ(last("normal_stress"), state.stress.normal);
  EXPECT_EQ(last("mean_stress"), sample.stress().mean());
  EXPECT_EQ(last("pore_pressure"), initial_normal_stress(settings.slope) - state.stress.normal);
  EXPECT_EQ(last("driving_stress"), state.driving_stress);
  EXPECT_EQ(last("global_rate"), state.global_rate);
  EXPECT_EQ(last("rate_asked"), state.rate_asked);
  EXPECT_EQ(last("rate_applied"), state.rate_applied);
  EXPECT_EQ(last("local_time"), state.local_time);
  EXPECT_EQ(last("local_steps"), static_cast<double>(state.local_steps));
  EXPECT_EQ(last("void_ratio"), sample.void_ratio());
  EXPECT_GT(last("volumetric_strain"), 0.0);
  EXPECT_GT(state.rate_applied, 0.0);
  EXPECT_DOUBLE_EQ(last("inertial_number"), state.rate_applied * 6e-3 * std::sqrt(2650.0 / sample.stress().mean()));
  EXPECT_DOUBLE_EQ(last("global_inertial_number"),
                   state.global_rate * 6e-3 * std::sqrt(2650.0 / sample.stress().mean()));
}

TEST(RunSlide, TakesRowsAtMultiplesOfTheTime) {
  ElasticSample sample = elastic();
  Slide slide(pulsed(), sample);
  SlideRecord record{.spacing = {.interval = 0.01}};
  run_slide(slide, {0.1003}, record);
  const auto& time = record.series.axis.values;
  ASSERT_EQ(time.size(), 11U);  // 0 to 0.10 s, which is the end up to half a step
  for (std::size_t row = 0; row < time.size(); ++row)
    EXPECT_NEAR(time[row], 0.01 * static_cast<double>(row), 1e-12);
}

TEST(RunSlide, TakesRowsAtMultiplesOfTheStrain) {
  SlideSettings settings = pulsed();
  settings.initial_velocity = 0.2;  // 1 1/s
  ElasticProperties soft;
  soft.shear_modulus = 1.0;
  soft.shear_stress = initial_shear_stress({});
  soft.normal_stress = initial_normal_stress({});
  ElasticSample sample(soft);
  settings.loading = NoChange{};
  Slide slide(settings, sample);
  SlideRecord record{.spacing = {.strain = 0.05}};
  EXPECT_EQ(run_slide(slide, {10.0, 0.5}, record), Stop::end_shear_strain);
  const auto& strain = record.series.column("shear_strain").values;
  ASSERT_EQ(strain.size(), 11U);
  for (std::size_t row = 1; row < strain.size(); ++row)
    EXPECT_NEAR(strain[row], 0.05 * static_cast<double>(row), 1.001e-3);  // up to a step of 1 ms late
}

TEST(RunSlide, NeverTakesMoreRowsThanAllowed) {
  ElasticSample sample = elastic();
  Slide slide(pulsed(), sample);
  SlideRecord record{.spacing = {.interval = 1e-3, .most_rows = 20}};
  run_slide(slide, {0.5}, record);
  const auto& time = record.series.axis.values;
  EXPECT_LE(time.size(), 20U);
  EXPECT_GE(time.size(), 10U);
  EXPECT_EQ(record.spacing.interval, 0.032);  // 500 rows in 20: doubled five times
  EXPECT_EQ(time.front(), 0.0);
  EXPECT_NEAR(time.back(), 0.5, 1e-12);
  for (std::size_t row = 1; row + 1 < time.size(); ++row)
    EXPECT_NEAR(time[row], 0.032 * static_cast<double>(row), 1e-12) << row;
}

TEST(RunSlide, EndsWithoutALastRowWhenItsObserverSays) {
  ElasticSample sample = elastic();
  Slide slide(pulsed(), sample);
  SlideRecord record{.spacing = {.interval = 0.01}};
  std::size_t steps = 0;
  EXPECT_EQ(run_slide(slide, {0.1}, record, [&](const SlideState&) { return ++steps < 37; }), Stop::not_yet);
  EXPECT_EQ(slide.state().exchanges, 37);
  EXPECT_EQ(record.series.rows(), 4U);  // at 0, 10, 20 and 30 steps
}

TEST(RunSlide, GoesOnWhereItWasInterruptedAsIfItHadNotBeen) {
  ElasticSample sample = elastic(), other_sample = elastic();
  Slide slide(pulsed(), sample), other(pulsed(), other_sample);
  const RowSpacing spacing{.interval = 5e-3, .most_rows = 16};
  SlideRecord record{.spacing = spacing}, other_record{.spacing = spacing};
  run_slide(slide, {0.3}, record);
  for (const int stop_after : {13, 50, 101}) {
    int steps = 0;
    run_slide(other, {0.3}, other_record, [&](const SlideState&) { return ++steps < stop_after; });
  }
  EXPECT_EQ(run_slide(other, {0.3}, other_record), Stop::end_time);
  ASSERT_EQ(record.series.rows(), other_record.series.rows());
  EXPECT_EQ(record.series.axis.values, other_record.series.axis.values);
  EXPECT_EQ(record.series.column("shear_stress").values, other_record.series.column("shear_stress").values);
}

TEST(RunSlide, KeepsWhereItsRowsAreDueWhenTheStrainRunsBack) {
  // The strain oscillates: between two rows it falls below the last row. No strain may get two rows.
  const auto swing = [] {
    SlideSettings settings = pulsed();
    settings.initial_velocity = 0.05;
    return settings;
  };
  ElasticSample sample = elastic(), other_sample = elastic();
  Slide slide(swing(), sample), other(swing(), other_sample);
  const RowSpacing spacing{.strain = 1e-4};
  SlideRecord record{.spacing = spacing}, other_record{.spacing = spacing};
  run_slide(slide, {0.1}, record);
  for (int at = 0; run_slide(other, {0.1}, other_record, [&](const SlideState&) { return ++at % 7 != 0; }) ==
                   Stop::not_yet;) {
  }
  EXPECT_GT(record.series.rows(), 10U);
  EXPECT_EQ(record.series.axis.values, other_record.series.axis.values);
}

TEST(RunSlide, StopsWhenTheSlideHasStopped) {
  ElasticSample sample = elastic();
  SlideSettings settings = pulsed();
  settings.initial_velocity = 0.1;
  Slide slide(settings, sample);
  SlideRecord record{.spacing = {.interval = 1.0}};
  EXPECT_EQ(run_slide(slide, {10.0, 10.0, 0.05}, record), Stop::sliding_stopped);
  // A quarter of a swing of omega = 155 /s, and a step.
  EXPECT_NEAR(slide.state().time, 0.5 * std::acos(-1.0) / 155.5, 1.1e-3);
  EXPECT_EQ(record.series.axis.values.back(), slide.state().time);
}

/// A slope whose own stresses are those of a lattice of grains.
SlopeProperties slope_of(const CellStress& stress) {
  SlopeProperties slope;
  const double share = stress.normal / initial_normal_stress(slope);
  slope.thickness *= share;
  slope.liquefiable_thickness *= share;
  slope.water_table *= share;
  slope.angle = 0.0;
  const double level = stress.normal / initial_normal_stress(slope);
  slope.gravity *= level;
  return slope;
}

/// A slide over 5 ms on grains in an engine.
Series slid(Engine& engine) {
  constexpr double local_step = 2e-6;
  DemSample sample(engine, touching_lattice(6, 10), {Material{}, local_step, 0.0});
  sample.strain({{0.0, 0.0}, 50, local_step});
  SlideSettings settings;
  settings.slope = slope_of(sample.stress());
  settings.initial_velocity = 5.0 * settings.slope.liquefiable_thickness;
  settings.rate = GlobalRate{};
  settings.passing = {CarryRemainder{10}, local_step, 1000};
  sample.start_linear_velocity_field(5.0);
  Slide slide(settings, sample);
  SlideRecord record{.spacing = {.interval = 5e-4}};
  run_slide(slide, {5e-3}, record);
  return record.series;
}

TEST(RunSlide, GoesOnWithAdaptiveStepsOnGrainsWithTheSameBits) {
  constexpr double local_step = 1e-6;
  const auto new_sample = [] {
    auto made = std::make_unique<DemSample>(std::make_unique<DoubleEngine>(NativeOptions{.threads = 1}),
                                            touching_lattice(), EngineSettings{Material{}, local_step, 0.0});
    made->strain({{0.0, 0.0}, 50, local_step});
    return made;
  };
  const auto first = new_sample();
  DemSample& sample = *first;
  SlideSettings settings;
  settings.slope = slope_of(sample.stress());
  settings.initial_velocity = 5.0 * settings.slope.liquefiable_thickness;
  settings.rate = GlobalRate{};
  settings.passing = {CarryRemainder{10}, local_step, 1000};
  settings.adaptive = AdaptiveTimeStep{local_step, 4e-6, 60};
  Slide whole(settings, sample);
  SlideState state;
  SampleState grains;
  for (int step = 0; step < 20; ++step) {
    if (step == 7) {
      state = whole.state();
      grains = sample.state();
    }
    whole.step();
  }
  EXPECT_GT(state.adaptive.time_step, local_step);  // else the step never changed
  const auto other = new_sample();
  Slide second(settings, *other);
  other->restore(grains);
  second.restore(state);
  for (int step = 7; step < 20; ++step) second.step();
  EXPECT_EQ(second.state().stress.shear, whole.state().stress.shear);
  EXPECT_EQ(second.state().velocity, whole.state().velocity);
  EXPECT_EQ(second.state().local_steps, whole.state().local_steps);
}

TEST(RunSlideRanks, EveryRankHasTheSlopeOfAllGrainsOfLiggghts) {
  // LIGGGHTS deals its grains out over the ranks, the native engine has all of them on each: the slope must be that of
  // all of them, the same to the bit on every rank, and the same on both engines but for rounding.
  const auto liggghts = make_engine("liggghts", testing::TempDir() + "slide_run_ranks.log", 0, all_ranks());
  const auto native = make_engine("native", {});
  const Series over_ranks = slid(*liggghts), alone = slid(*native);
  for (const char* name : {"velocity", "displacement", "shear_stress", "normal_stress", "rate_applied"}) {
    const std::vector<double>&found = over_ranks.column(name).values, &expected = alone.column(name).values;
    ASSERT_EQ(found.size(), expected.size());
    double scale = 0.0;
    for (const double value : expected) scale = std::max(scale, std::abs(value));
    for (std::size_t row = 0; row < found.size(); ++row) {
      EXPECT_NEAR(found[row], expected[row], 1e-7 * scale) << name << ", row " << row;
      EXPECT_TRUE(equal_on_all_ranks(found[row])) << name << ", row " << row;
    }
  }
}

TEST(RunSlide, ShearsGrainsAndMeasuresTheirProfiles) {
  constexpr double local_step = 2e-6;
  const auto engine = make_engine(engine_names_of_build().front(), testing::TempDir() + "slide_run.log");
  Assembly lattice = touching_lattice(6, 10);
  DemSample sample(*engine, lattice, {Material{}, local_step, 0.0});
  sample.strain({{0.0, 0.0}, 50, local_step});
  SlideSettings settings;
  settings.slope = slope_of(sample.stress());
  settings.time_step = 1e-4;
  settings.initial_velocity = 5.0 * settings.slope.liquefiable_thickness;
  settings.rate = GlobalRate{};
  settings.passing = {CarryRemainder{10}, local_step, 1000};
  settings.residual = ResidualTreatment::fades;
  sample.start_linear_velocity_field(5.0);
  Slide slide(settings, sample);
  const GrainScale grains{lattice.mean_diameter(), Material{}.density};
  SlideRecord record{.spacing = {.interval = 1e-3}, .grains = grains};
  run_slide(slide, {5e-3}, record);
  const Assembly end = sample.assembly();
  const Profiles last = profiles(end, evaluate_contact_forces(end, Material{}, local_step), 10);
  EXPECT_NO_THROW(record.series.check());
  EXPECT_EQ(record.series.rows(), 6U);
  EXPECT_NEAR(sample.time() - 50 * local_step, slide.state().local_time, 1e-15);
  EXPECT_NEAR(sample.shear_strain() + slide.state().owed.shear, slide.state().strain.shear, 1e-12);
  EXPECT_GT(slide.state().strain.shear, 0.01);
  EXPECT_EQ(record.series.column("mean_stress").values.back(), sample.mean_stress());
  ASSERT_EQ(last.velocity.size(), 10U);
  EXPECT_GT(last.velocity.back(), last.velocity.front() + 0.1);
}

}  // namespace
}  // namespace flowslide::slide_run_test
