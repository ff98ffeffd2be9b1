// SPDX-License-Identifier: GPL-2.0-or-later
// The coupled system against exact solutions: order of accuracy, stability, energy, rates.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "coupling/slide.hpp"
#include "elastic_slide.hpp"

namespace flowslide {
namespace {

constexpr double v0 = 0.1;                  // m/s
constexpr double end = 1.0 / 32.0;          // s, some 5 radians of the swing (omega = 155 rad/s)
constexpr std::int64_t plenty = 1'000'000;  // steps per exchange

SlideSettings swinging(double time_step, const PassingRule& rule, double local_time_step) {
  SlideSettings settings;
  settings.time_step = time_step;
  settings.rate = GlobalRate{};
  settings.passing = {rule, local_time_step, plenty};
  settings.initial_velocity = v0;
  return settings;
}

/// Error of x at the end, over the amplitude v0/omega.
double error_of(const SlideSettings& settings, double viscosity = 0.0) {
  ElasticProperties properties = elastic_for(settings.slope);
  properties.viscosity = viscosity;
  ElasticSample sample(properties);
  Slide slide(settings, sample);
  run_until(slide, end);
  const Swing exact = exact_swing(settings.slope, properties, v0, slide.state().time);
  return std::abs(slide.state().sliding.displacement - exact.displacement) * frequency(settings.slope, properties) / v0;
}

/// log2 of what halving dt_G gains, from 512 steps (omega dt = 1e-2) on; dt_L is a share of dt_G.
double order_of(const PassingRule& rule, double local_share, double viscosity = 0.0) {
  const double coarse = end / 512.0, fine = end / 1024.0;
  return std::log2(error_of(swinging(coarse, rule, local_share * coarse), viscosity) /
                   error_of(swinging(fine, rule, local_share * fine), viscosity));
}

TEST(SlideAccuracy, SlidingIsOfSecondOrderWithEveryRuleThatAsksTheSampleAtEveryStep) {
  // Tolerance: the next order is a share omega dt = 1e-2.
  EXPECT_NEAR(order_of(WholeIncrement{}, 1.0 / 16.0), 2.0, 0.02);
  EXPECT_NEAR(order_of(AccumulateAndReset{10}, 1.0 / 16.0), 2.0, 0.02);
  EXPECT_NEAR(order_of(CarryRemainder{10}, 1.0 / 16.0), 2.0, 0.02);
  EXPECT_NEAR(order_of(VariableTimeStep{}, 1.0), 2.0, 0.02);
  EXPECT_LT(error_of(swinging(end / 1024.0, VariableTimeStep{}, 1.0)), 1e-4);
}

TEST(SlideAccuracy, ASampleThatKnowsItsRateOrIsAskedSeldomLeavesTheFirstOrder) {
  // A tenth of critical damping: the rate told is that of half a step before.
  const double viscosity = 0.2 * 0.2 * 3100.0 * 155.0;
  EXPECT_NEAR(order_of(VariableTimeStep{}, 1.0, viscosity), 1.0, 0.05);
  EXPECT_NEAR(order_of(CarryRemainder{10}, 1.0 / 16.0, viscosity), 1.0, 0.05);
  EXPECT_LT(error_of(swinging(end / 1024.0, VariableTimeStep{}, 1.0), viscosity), 0.01);
  // dt_G = dt_L: the stress of every tenth step is held.
  EXPECT_NEAR(order_of(CarryRemainder{10}, 1.0), 1.0, 0.15);
  EXPECT_NEAR(order_of(AccumulateAndReset{11}, 1.0), 1.0, 0.15);
}

TEST(SlideAccuracy, AsPrintedEqs15And18DoNotConvergeOnASampleThatKnowsItsRate) {
  // At 16 local steps per exchange both run 17: the rate, and with it the damping, is 1/17 too low however small dt_G.
  const double viscosity = 0.2 * 0.2 * 3100.0 * 155.0;
  for (const PassingRule& rule : {PassingRule{WholeIncrement{}}, PassingRule{AccumulateAndReset{10}}}) {
    EXPECT_NEAR(order_of(rule, 1.0 / 16.0, viscosity), 0.0, 0.05);
    const double step = end / 1024.0;
    EXPECT_GT(error_of(swinging(step, rule, step / 16.0), viscosity),
              100.0 * error_of(swinging(step, CarryRemainder{10}, step / 16.0), viscosity));
  }
}

TEST(SlideAccuracy, AStressThatIsHeldDrivesTheSwingOn) {
  // By exp(omega^2 (t_h - dt) t/4) with t_h = 10 dt held: delays of (t_h - dt)/2 in the mean.
  const double step = end / 8192.0;
  SlideSettings settings = swinging(step, CarryRemainder{10}, step);
  ElasticSample sample(elastic_for(settings.slope));
  Slide slide(settings, sample);
  const double omega = frequency(settings.slope, elastic_for(settings.slope));
  const double turns = 16.0 * std::acos(-1.0) / omega;  // 8 periods
  run_until(slide, turns - 0.02 / omega);
  double fastest = 0.0;
  while (slide.state().time < turns + 0.02 / omega) {
    slide.step();
    fastest = std::max(fastest, slide.state().velocity);
  }
  const double growth = 0.25 * omega * omega * 9.0 * step * turns;
  ASSERT_GT(growth, 0.06);
  // The velocity peaks once a period. Near the turning points more is owed than n_accum steps of the small rate
  // there, and held for less; a fifth covers it.
  EXPECT_NEAR(std::log(fastest / v0), growth, 0.2 * growth);
}

TEST(SlideAccuracy, StabilityEndsWhereTheoryPutsIt) {
  const SlopeProperties slope;
  const double limit = sliding_time_step_limit(slope, elastic_for(slope).shear_modulus);
  const auto largest_swing = [&](double share, int steps) {
    const SlideSettings settings = swinging(share * limit, VariableTimeStep{}, limit);
    ElasticSample sample(elastic_for(slope));
    Slide slide(settings, sample);
    double largest = 0.0;
    for (int n = 0; n < steps; ++n) {
      slide.step();
      largest = std::max(largest, std::abs(slide.state().sliding.displacement));
    }
    return largest * frequency(slope, elastic_for(slope)) / v0;
  };
  // As for the slide alone (sliding_test): bounded by 1/sqrt(1 - 0.99^2) = 7.1, or a growth of 1.32 per step.
  EXPECT_LT(largest_swing(0.99, 10'000), 7.2);
  EXPECT_GT(largest_swing(1.01, 200), 1e20);
}

TEST(SlideAccuracy, WorkDoneByTheStressesIsTheEnergyGained) {
  // Pulse on the swing: m v^2/2 against the integral of (tau_d - tau) dx by trapezia, over the energy at the start.
  const auto imbalance = [](int steps) {
    SlideSettings settings = swinging(end / steps, VariableTimeStep{}, 1.0);
    settings.loading = SinePulse{1e3, 2.0 * end};
    ElasticSample sample(elastic_for(settings.slope));
    Slide slide(settings, sample);
    double work = 0.0;
    for (int n = 0; n < steps; ++n) {
      const SlideState before = slide.state();
      slide.step();
      const SlideState& now = slide.state();
      work += 0.5 * (before.driving_stress - before.stress.shear + now.driving_stress - now.stress.shear) *
              (now.sliding.displacement - before.sliding.displacement);
    }
    const double gained = 0.5 * 3100.0 * (slide.state().velocity * slide.state().velocity - v0 * v0);
    return std::abs(work - gained) / (0.5 * 3100.0 * v0 * v0);
  };
  EXPECT_NEAR(std::log2(imbalance(512) / imbalance(1024)), 2.0, 0.02);  // next order: omega dt = 1e-2
  EXPECT_LT(imbalance(1024), 1e-4);
}

/// Error of p_w at t = 0.05 s on a sample that begins with 3 % of sigma_0 as excess pore pressure, over its start.
double error_of_drainage(ConsolidationScheme scheme, double conductivity, int steps, const StrainPassing& passing) {
  SlideSettings settings;
  settings.slope.hydraulic_conductivity = conductivity;
  settings.time_step = 0.05 / steps;
  settings.consolidation = scheme;
  settings.oedometric_modulus = ElasticProperties{}.oedometric_modulus;
  settings.passing = passing;
  settings.rate = ConstantInertialNumber{1e-4, 1.0, {}};
  settings.residual = ResidualTreatment::left_out;
  ElasticSample sample(elastic_for(settings.slope, 0.97));
  Slide slide(settings, sample);
  const double start = slide.basal_pore_pressure();
  for (int n = 0; n < steps; ++n) slide.step();
  const double rate = consolidation_coefficient(settings.slope) * settings.oedometric_modulus;
  // What the sample is still owed is drained already.
  const double excess = slide.basal_pore_pressure() - settings.oedometric_modulus * slide.state().owed.compression;
  return std::abs(excess / start - std::exp(-rate * 0.05));
}

TEST(SlideAccuracy, DrainageIsOfFirstOrderByEulerAndExactByTheExponential) {
  const StrainPassing passing{VariableTimeStep{}, 1.0, plenty};
  const auto euler = [&](int steps) {
    return error_of_drainage(ConsolidationScheme::euler, 1e-4, steps, passing);
  };
  EXPECT_NEAR(std::log2(euler(256) / euler(512)), 1.0, 0.01);  // next order: C M dt/2 = 2e-3
  EXPECT_GT(euler(512), 1e-4);
  for (const int steps : {1, 7, 512})
    for (const double conductivity : {1e-5, 1e-4, 1e-2}) {
      // Rounding of sigma to 4e-12 Pa and of M epsilon over an excess of 850 Pa.
      EXPECT_LT(error_of_drainage(ConsolidationScheme::exponential, conductivity, steps, passing), 1e-11);
    }
}

TEST(SlideAccuracy, ExponentialDrainageIsExactHoweverSeldomTheSampleIsAsked) {
  // The whole strain, 850 Pa/40 MPa = 2e-5, makes two exchanges of 10 steps of 1e-6.
  const StrainPassing passing{CarryRemainder{10}, 1e-6, plenty};
  EXPECT_LT(error_of_drainage(ConsolidationScheme::exponential, 1e-3, 512, passing), 1e-11);
  // Euler goes on with the pressure of the last exchange: beyond the truth, half-way between two exchanges or so.
  EXPECT_GT(error_of_drainage(ConsolidationScheme::euler, 1e-3, 512, passing), 0.01);
}

TEST(SlideAccuracy, EulerDrainageEndsWhereTheoryPutsIt) {
  SlopeProperties slope;
  slope.hydraulic_conductivity = 1e-3;
  const double limit = consolidation_time_step_limit(slope, ElasticProperties{}.oedometric_modulus);
  const auto left = [&](ConsolidationScheme scheme, double share) {
    SlideSettings settings;
    settings.slope = slope;
    settings.time_step = share * limit;
    settings.consolidation = scheme;
    settings.oedometric_modulus = ElasticProperties{}.oedometric_modulus;
    settings.passing = {VariableTimeStep{}, 1.0, plenty};
    settings.residual = ResidualTreatment::left_out;
    ElasticProperties sample_properties = elastic_for(slope, 0.97);
    sample_properties.shear_modulus = 1.0;  // no swing: only drainage is under test
    ElasticSample sample(sample_properties);
    Slide slide(settings, sample);
    for (int n = 0; n < 500; ++n) slide.step();
    return std::abs(slide.basal_pore_pressure());
  };
  EXPECT_LT(left(ConsolidationScheme::euler, 0.99), 0.1);    // 850 Pa 0.98^500 = 0.035 Pa
  EXPECT_GT(left(ConsolidationScheme::euler, 1.01), 1e6);    // 850 Pa 1.02^500 = 1.7e7 Pa
  EXPECT_LT(left(ConsolidationScheme::exponential, 100.0), 0.1);
}

/// A slide at 0.1 m/s, 0.5 1/s, after 0.5 ms of local steps of 1e-6 s.
SlideState state_after(const RateRule& rate, const PassingRule& rule, double time_step) {
  SlideSettings settings = swinging(time_step, rule, 1e-6);
  settings.rate = rate;
  ElasticSample sample(elastic_for(settings.slope));
  Slide slide(settings, sample);
  // Not before the last exchange has run its sample: rates asked and applied belong together then.
  while (slide.state().time < 5e-4 || slide.state().steps == 0) slide.step();
  return slide.state();
}

double share_of_rate(const RateRule& rate, const PassingRule& rule, double time_step) {
  const SlideState state = state_after(rate, rule, time_step);
  return state.rate_applied / state.rate_asked;
}

TEST(SlideAccuracy, RateAskedIsRateAppliedWhateverTheGlobalStep) {
  const ConstantInertialNumber constant{1e-2, 0.0, {}};  // 5.45 1/s at sigma_0
  for (const double step : {1e-3, 1e-4, 1e-5, 1e-6}) {
    EXPECT_NEAR(share_of_rate(constant, VariableTimeStep{}, step), 1.0, 1e-12) << step;
    EXPECT_NEAR(share_of_rate(constant, CarryRemainder{10}, step), 1.0, 1e-12) << step;
    EXPECT_NEAR(share_of_rate(GlobalRate{}, VariableTimeStep{}, step), 1.0, 1e-12) << step;
    EXPECT_NEAR(share_of_rate(GlobalRate{}, CarryRemainder{10}, step), 1.0, 1e-12) << step;
    const double printed = share_of_rate(constant, AccumulateAndReset{10}, step);
    EXPECT_LE(printed, 1.0);
    EXPECT_GE(printed, 1.0 - 1.0 / 10.0);
  }
}

TEST(SlideAccuracy, Eq15LosesTheRateAsTheGlobalStepShrinks) {
  // Eq. 16b: one local step passes the strain of dt_G at the rate of the slope times dt_G/dt_L, however large the rate
  // asked for is.
  const ConstantInertialNumber constant{1e-2, 0.0, {}};
  EXPECT_GT(share_of_rate(constant, WholeIncrement{}, 1e-3), 0.98);  // 91 steps and one
  for (const double step : {1e-6, 1e-7}) {
    const SlideState state = state_after(constant, WholeIncrement{}, step);
    EXPECT_NEAR(state.rate_applied, state.global_rate * step / 1e-6, 1e-12) << step;
    EXPECT_LT(state.rate_applied, 0.1 * state.rate_asked * step / 1e-6) << step;
  }
}

TEST(SlideAccuracy, Eq15DriftsToTheQuasiStaticAnswerAsTheGlobalStepShrinks) {
  // What Fig. 6 shows, on a sample whose tau has a part eta d(gamma)/dt_L: 10 kPa at the rate asked for.
  const ConstantInertialNumber constant{1e-2, 0.0, {}};
  const double viscosity = 1e4 / rate_asked(constant, 0.0, initial_normal_stress(SlopeProperties{}), 0.0);
  const auto viscous_stress = [&](const PassingRule& rule, double time_step) {
    SlideSettings settings = swinging(time_step, rule, 1e-6);
    settings.rate = constant;
    settings.loading = StressTable{{0.0}, {1e4}};  // holds the slide against it
    ElasticProperties properties = elastic_for(settings.slope);
    properties.viscosity = viscosity;
    ElasticSample sample(properties);
    Slide slide(settings, sample);
    while (slide.state().time < 5e-4 || slide.state().steps == 0) slide.step();
    return slide.state().stress.shear - properties.shear_stress - properties.shear_modulus * sample.shear_strain();
  };
  double last = 1e4;
  for (const double step : {1e-4, 1e-6, 1e-7}) {
    const double whole = viscous_stress(WholeIncrement{}, step);
    EXPECT_LT(whole, last) << step;
    last = whole;
    for (const PassingRule& rule : {PassingRule{CarryRemainder{10}}, PassingRule{VariableTimeStep{}}})
      EXPECT_NEAR(viscous_stress(rule, step), 1e4, 1e-6) << step;
  }
  EXPECT_LT(last, 0.02 * 1e4);
}

}  // namespace
}  // namespace flowslide
