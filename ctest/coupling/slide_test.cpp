// SPDX-License-Identifier: GPL-2.0-or-later
#include "coupling/slide.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "elastic_slide.hpp"
#include "sample/critical_state_sample.hpp"
#include "sample/failure.hpp"

namespace flowslide {
namespace {

/// An elastic sample that counts how often it is asked.
class CountingSample : public ElasticSample {
 public:
  using ElasticSample::ElasticSample;
  CellStress strain(const LocalRun& run) override {
    ++calls;
    return ElasticSample::strain(run);
  }
  int calls = 0;
};

SlideSettings pulsed() {
  SlideSettings settings;
  settings.loading = SinePulse{1e3, 0.05};
  settings.rate = GlobalRate{};
  settings.passing = {CarryRemainder{10}, 1e-5, 1000};
  return settings;
}

TEST(Slide, RefusesAPulseThatItsStepsWouldMiss) {
  const SlideSettings settings = pulsed();
  ElasticSample sample(elastic_for(settings.slope));
  SlideSettings shorter = settings;
  shorter.loading = SinePulse{1e3, 10.0 * settings.time_step};
  EXPECT_NO_THROW(Slide(shorter, sample));
  shorter.loading = SinePulse{1e3, 9.9 * settings.time_step};
  EXPECT_THROW(Slide(shorter, sample), std::invalid_argument);
}

TEST(Slide, RestsInBalanceAndLeavesItsSampleAlone) {
  SlideSettings settings = pulsed();
  settings.loading = NoChange{};
  for (const PassingRule& rule : {PassingRule{WholeIncrement{}}, PassingRule{AccumulateAndReset{1}},
                                  PassingRule{CarryRemainder{10}}, PassingRule{VariableTimeStep{}}}) {
    settings.passing.rule = rule;
    CountingSample sample(elastic_for(settings.slope));
    Slide slide(settings, sample);
    for (int n = 0; n < 100; ++n) slide.step();
    EXPECT_EQ(slide.state().sliding.displacement, 0.0);
    EXPECT_EQ(slide.state().velocity, 0.0);
    EXPECT_EQ(slide.state().rate_asked, 0.0);
    EXPECT_EQ(slide.state().local_steps, 0);
    EXPECT_EQ(sample.calls, 0);
    EXPECT_DOUBLE_EQ(slide.state().time, 100 * 1e-4);
  }
}

TEST(Slide, BeginsWithHalfAStepOfItsAcceleration) {
  SlideSettings settings = pulsed();
  settings.loading = StressTable{{0.0}, {310.0}};  // 0.1 m/s^2
  settings.initial_velocity = 0.5;
  ElasticSample sample(elastic_for(settings.slope));
  const Slide slide(settings, sample);
  EXPECT_EQ(slide.state().velocity, 0.5);
  EXPECT_NEAR(slide.state().sliding.velocity, 0.5 + 0.5e-4 * 0.1, 1e-15);
  EXPECT_NEAR(slide.state().driving_stress - slide.state().stress.shear, 310.0, 1e-9);
}

TEST(Slide, AsksItsSampleOnlyWhenThereAreStepsToRun) {
  SlideSettings settings = pulsed();
  settings.time_step = 1e-5;  // dt_L, so that the sample is asked at every tenth step or so
  CountingSample sample(elastic_for(settings.slope));
  Slide slide(settings, sample);
  int running = 0;
  std::int64_t steps = 0;
  for (int n = 0; n < 1000; ++n) {
    slide.step();
    running += slide.state().steps > 0;
    steps += slide.state().steps;
  }
  EXPECT_EQ(sample.calls, running);
  EXPECT_EQ(slide.state().local_steps, steps);
  EXPECT_GT(running, 50);
  EXPECT_LT(running, 110);
}

TEST(Slide, ClocksAgreeAtTheRateOfTheSlope) {
  SlideSettings settings = pulsed();
  settings.loading = NoChange{};
  settings.initial_velocity = 0.1;
  settings.time_step = 1.3e-5;
  ElasticProperties soft = elastic_for(settings.slope);
  soft.shear_modulus = 1.0;  // a steady slide
  ElasticSample sample(soft);
  Slide slide(settings, sample);
  for (int n = 0; n < 2000; ++n) {
    slide.step();
    // The local clock lags by what has accumulated: less than n_accum steps, and the step that is broken.
    const double lag = slide.state().time - slide.state().local_time;
    ASSERT_GT(lag, -1e-12);
    ASSERT_LT(lag, 11.0 * 1e-5);
  }
}

TEST(Slide, StrainOfTheSampleAndStrainOwedMakeThatOfTheLayer) {
  SlideSettings settings = pulsed();
  settings.slope.hydraulic_conductivity = 1e-4;
  settings.time_step = 1e-5;
  ElasticSample sample(elastic_for(settings.slope));
  Slide slide(settings, sample);
  for (int n = 0; n < 10'000; ++n) {
    slide.step();
    // v crosses zero once every 20 ms, and sigma its target: strain is owed while the rate asked for vanishes.
    ASSERT_LE(slide.state().steps, 1000);
    ASSERT_NEAR(sample.shear_strain() + slide.state().owed.shear, slide.state().strain.shear, 1e-15);
    ASSERT_LT(std::abs(slide.state().owed.shear), 1e-5);
  }
  EXPECT_NEAR(slide.state().strain.shear, slide.state().sliding.displacement / 0.2, 1e-15);
}

TEST(Slide, GoesOnBitForBitFromAStateThatWasKept) {
  SlideSettings settings = pulsed();
  settings.slope.hydraulic_conductivity = 1e-4;
  settings.time_step = 1.3e-5;
  ElasticSample sample(elastic_for(settings.slope));
  Slide slide(settings, sample);
  for (int n = 0; n < 777; ++n) slide.step();
  ElasticSample start(elastic_for(settings.slope));
  Slide other(settings, start);
  other.restore(slide.state());
  start = sample;
  for (int n = 0; n < 777; ++n) {
    slide.step();
    other.step();
    ASSERT_EQ(slide.state().sliding.displacement, other.state().sliding.displacement);
    ASSERT_EQ(slide.state().stress.shear, other.state().stress.shear);
    ASSERT_EQ(slide.state().owed.compression, other.state().owed.compression);
    ASSERT_EQ(slide.state().local_time, other.state().local_time);
  }
}

/// A loose sample that a servo left 100 Pa short of tau_0.
CriticalStateSample loose_sample(const SlopeProperties& slope) {
  CriticalStateProperties properties;
  properties.void_ratio = 0.85;  // 4 Pa of friction at the critical state
  properties.largest_substep = 1e-5;
  properties.normal_stress = initial_normal_stress(slope);
  properties.shear_stress = initial_shear_stress(slope) - 100.0;
  return CriticalStateSample(properties);
}

TEST(Slide, LiquefiedSampleLeavesTheSlopeToItsWeight) {
  for (const auto treatment : {ResidualTreatment::fades, ResidualTreatment::left_out, ResidualTreatment::stays}) {
    SlideSettings settings;
    settings.loading = ConstantRate{1e6 / 60.0, 0.5};
    settings.rate = ConstantInertialNumber{1e-4, 1.0, {}};
    settings.passing = {WholeIncrement{}, 1e-5, 1'000'000};
    settings.residual = treatment;
    CriticalStateSample sample = loose_sample(settings.slope);
    Slide slide(settings, sample);
    run_until(slide, 0.8);
    const double before = slide.state().velocity;
    run_until(slide, 1.0);
    const double told = treatment == ResidualTreatment::stays ? 100.0 : 0.0;
    EXPECT_NEAR(slide.state().stress.shear, told, 10.0);
    EXPECT_NEAR(slide.basal_pore_pressure(), initial_normal_stress(settings.slope), 100.0);
    // a = (tau_d - tau)/m; 10 Pa of the driving 11 kPa are 0.1 %.
    const double acceleration = (slide.state().driving_stress - told) / 3100.0;
    EXPECT_NEAR((slide.state().velocity - before) / 0.2, acceleration, 1e-3 * acceleration);
    // sigma is near zero: the rate asked for is the floor, and finite.
    EXPECT_EQ(slide.state().rate_asked, 1.0);
    EXPECT_GT(slide.state().largest_velocity, 1.0);
  }
}

TEST(Slide, DrainageStopsASlideThatGoesOnWithoutIt) {
  const auto velocity_after = [](double conductivity) {
    SlideSettings settings;
    settings.slope.hydraulic_conductivity = conductivity;
    settings.loading = SinePulse{6e3, 2.0};
    settings.rate = ConstantInertialNumber{1e-4, 1.0, {}};
    settings.passing = {WholeIncrement{}, 1e-5, 1'000'000};
    CriticalStateSample sample = loose_sample(settings.slope);
    Slide slide(settings, sample);
    run_until(slide, 2.5);
    return slide.state().velocity;
  };
  EXPECT_GT(velocity_after(0.0), 2.0);
  EXPECT_LT(velocity_after(1e-3), 0.01);
}

TEST(Slide, RefusesSettingsThatDoNotFit) {
  const auto refuse = [](auto change) {
    SlideSettings settings = pulsed();
    change(settings);
    ElasticSample sample(elastic_for(SlopeProperties{}));
    EXPECT_THROW(validate(settings), std::invalid_argument);  // before there is a sample
    EXPECT_THROW(Slide(settings, sample), std::invalid_argument);
  };
  refuse([](SlideSettings& s) { s.time_step = 0.0; });
  refuse([](SlideSettings& s) { s.time_step = -1e-4; });
  refuse([](SlideSettings& s) { s.slope.hydraulic_conductivity = -1e-5; });
  refuse([](SlideSettings& s) { s.loading = SinePulse{3e3, 0.0}; });
  refuse([](SlideSettings& s) { s.passing.rule = CarryRemainder{0}; });
  refuse([](SlideSettings& s) { s.rate = ConstantInertialNumber{0.0, 0.0, {}}; });
  refuse([](SlideSettings& s) { s.oedometric_modulus = 0.0; });
  refuse([](SlideSettings& s) { s.initial_velocity = std::nan(""); });
  EXPECT_NO_THROW(validate(pulsed()));
}

TEST(Slide, RefusesTheSampleOfAnotherSlope) {
  SlideSettings settings = pulsed();
  settings.slope.angle = 0.3;
  ElasticSample sample(elastic_for(SlopeProperties{}));  // at 5 degrees
  EXPECT_NO_THROW(validate(settings));
  EXPECT_THROW(Slide(settings, sample), NumericalFailure);
}

TEST(Slide, StopsWhenItIsNoLongerFinite) {
  SlideSettings settings = pulsed();
  settings.loading = NoChange{};
  settings.initial_velocity = 0.1;
  settings.time_step = 0.1;  // far beyond the limit of stability, some 2e-3 s: the swing grows without end
  ElasticSample sample(elastic_for(settings.slope));
  Slide slide(settings, sample);
  try {
    for (int n = 0; n < 100000; ++n) slide.step();
    FAIL() << "v = " << slide.state().velocity;
  } catch (const NumericalFailure& failure) {
    EXPECT_NE(std::string(failure.what()).find("the slide is not finite at t = "), std::string::npos) << failure.what();
    EXPECT_NE(std::string(failure.what()).find("use a smaller time step than dt_G = 0.1 s"), std::string::npos);
  }
}

/// An elastic sample that notes which runs were to be measured.
class MeasuredSample : public ElasticSample {
 public:
  using ElasticSample::ElasticSample;
  CellStress strain(const LocalRun& run) override {
    measured += run.measured ? 1 : 0;
    ++runs;
    return ElasticSample::strain(run);
  }
  int runs = 0, measured = 0;
};

TEST(Slide, HoldsTheStressBetweenMeasuredRuns) {
  SlideSettings settings = pulsed();
  settings.initial_velocity = 0.1;
  settings.passing.rule = WholeIncrement{};
  settings.stress_interval = 5;
  MeasuredSample sample(elastic_for(settings.slope));
  Slide slide(settings, sample);
  const double before = slide.state().stress.shear;
  for (int n = 1; n <= 4; ++n) {
    slide.step();
    EXPECT_EQ(slide.state().stress.shear, before) << n;
  }
  slide.step();
  EXPECT_EQ(slide.state().stress.shear, sample.stress().shear);
  EXPECT_NE(slide.state().stress.shear, before);
  for (int n = 0; n < 95; ++n) slide.step();
  EXPECT_EQ(sample.runs, 100);
  EXPECT_EQ(sample.measured, 20);
}

TEST(Slide, GivesALiquefiedSampleAsMuchStrainAsProbesTake) {
  SlideSettings settings = pulsed();
  settings.initial_velocity = 0.1;
  settings.residual = ResidualTreatment::left_out;
  settings.passing.rule = WholeIncrement{};
  settings.rest = LiquefiedRest{initial_normal_stress(settings.slope), 1e-3, 9e-3};  // always "liquefied"
  ElasticProperties properties = elastic_for(settings.slope);
  properties.shear_modulus = 1.0;
  ElasticSample sample(properties);
  Slide slide(settings, sample);
  for (int n = 0; n < 4000; ++n) slide.step();
  // A tenth of the strain, but for one increment in every probe and the part of a cycle at the end.
  const double strain = slide.state().strain.shear;
  EXPECT_GT(strain, 0.1);
  EXPECT_NEAR(sample.shear_strain(), 0.1 * strain, 0.02 * strain);
  settings.rest.reset();
  ElasticSample all(properties);
  Slide without(settings, all);
  for (int n = 0; n < 4000; ++n) without.step();
  EXPECT_NEAR(all.shear_strain(), without.state().strain.shear, 1e-12);
}

TEST(Slide, RefusesToMeasureNever) {
  SlideSettings settings = pulsed();
  settings.stress_interval = 0;
  ElasticSample sample(elastic_for(settings.slope));
  EXPECT_THROW(Slide(settings, sample), std::invalid_argument);
}

}  // namespace
}  // namespace flowslide
