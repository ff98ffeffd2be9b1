// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <cstdint>
#include <optional>

#include "coupling/adaptive_time_step.hpp"
#include "coupling/liquefied_rest.hpp"
#include "coupling/rate_rule.hpp"
#include "coupling/strain.hpp"
#include "coupling/strain_passing.hpp"
#include "coupling/stress_reading.hpp"
#include "sample/sample.hpp"
#include "slope/consolidation.hpp"
#include "slope/driving_stress.hpp"
#include "slope/sliding.hpp"

namespace flowslide {

/// All settings of a slide except its sample.
struct SlideSettings {
  SlopeProperties slope;
  StressHistory loading;
  double time_step = 1e-4;           ///< dt_G, s
  ConsolidationScheme consolidation = ConsolidationScheme::exponential;
  double oedometric_modulus = 1e8;   ///< upper bound of the sample's M, Pa; only `exponential` uses it
  RateRule rate;
  StrainPassing passing;
  ResidualTreatment residual = ResidualTreatment::fades;
  double initial_velocity = 0.0;     ///< v^0, m/s
  std::int64_t stress_interval = 1;  ///< n: the stress is measured after every n-th run of the sample and held between
  std::optional<AdaptiveTimeStep> adaptive;  ///< empty: dt_L is that of `passing`;
                                             ///< otherwise `passing` gives the rule alone
  std::optional<LiquefiedRest> rest;  ///< empty: all strain is passed to the sample
};

/// All variables that change during a slide, except those of the sample. A slide that restores this state, with its
/// sample restored too, continues bit for bit.
struct SlideState {
  std::int64_t exchanges = 0;       ///< completed global steps
  double time = 0.0;                ///< t, the global clock, s
  SlidingState sliding;             ///< x at t and v at t + dt_G/2
  double velocity = 0.0;            ///< v at t, m/s
  double largest_velocity = 0.0;    ///< largest v so far, m/s
  Strain strain;                    ///< strain of the layer since the start
  Strain owed;                      ///< strain still to be passed to the sample: eps_accum
  double driving_stress = 0.0;      ///< tau_d at t, Pa
  BasalStress stress;               ///< tau and sigma as last measured, Pa
  double global_rate = 0.0;         ///< ||d(epsilon_G)||/dt_G of the last step, 1/s
  double rate_asked = 0.0;          ///< eps_L^U of the last step, 1/s
  double rate_applied = 0.0;        ///< strain rate of the last run of the sample, 1/s
  std::int64_t steps = 0;           ///< n_step of the last step; 0 while strain accumulates
  std::int64_t unmeasured_runs = 0;  ///< runs of the sample since its stress was last measured
  RestState rest;                   ///< used only with SlideSettings::rest
  AdaptiveTimeStepState adaptive;   ///< used only with SlideSettings::adaptive
  double local_time = 0.0;          ///< the local clock, s
  std::int64_t local_steps = 0;     ///< local steps of all exchanges
};

/// Shortest duration of a pulse, in global steps. The slope sees the pulse only at the exchanges. This reduces the
/// impulse of a sine over n steps by the fraction (pi/n)^2/12: 0.8 % for n = 10. For n = 1 nothing is left.
inline constexpr double least_steps_of_pulse = 10.0;

/// Throws std::invalid_argument if a setting is out of its range, or if a pulse is shorter than `least_steps_of_pulse`.
/// The caller checks stability: see sliding_time_step_limit and consolidation_time_step_limit.
void validate(const SlideSettings& settings);

/// A slope coupled to its sample: Algorithm 1. All ranks that share the sample compute the same exchanges.
///
/// One step, as printed, with v at half steps: x += dt v; epsilon by eq. 5; pass (gamma, epsilon) to the sample; take
/// its stress; a = (tau_d - tau)/m; v += dt a. The driving normal stress sigma_d is sigma_0. ResidualTreatment says how
/// the stress increments of step 8 are taken.
///
/// The order in dt_G is two without drainage, for a rate-independent sample that is strained at every step. It is one
/// with `euler`, with a rate-dependent sample, and while strain accumulates. Holding the stress for a time t_h delays
/// it by t_h/2 on average. This acts as negative damping: an oscillation of angular frequency omega grows as
///   exp(omega^2 t_h t/4).
/// dt_G >= n_accum dt_L avoids the delay at the strain rate of the slope.
class Slide {
 public:
  /// Starts at the initial velocity. `sample` must outlive the slide. Throws as `validate`, and as StressReading if the
  /// stress of the sample does not suit the slope.
  Slide(const SlideSettings& settings, Sample& sample);

  /// Makes one global step dt_G. Throws NumericalFailure if the sample fails or if the slide is not finite any more.
  void step();

  const SlideState& state() const { return state_; }
  /// Continues from the state of a slide with the same settings. The caller restores the sample.
  void restore(const SlideState& state) { state_ = state; }

  /// sigma_d - sigma, the excess pore pressure at the base, Pa.
  double basal_pore_pressure() const { return driving_normal_stress_ - state_.stress.normal; }
  const SlideSettings& settings() const { return settings_; }
  const StressReading& reading() const { return reading_; }
  const Sample& sample() const { return sample_; }

 private:
  StrainPassing passing();
  void run_sample(LocalRun run);
  void check_finite() const;

  SlideSettings settings_;
  Sample& sample_;
  DrivingStress driving_;
  double driving_normal_stress_;
  Sliding sliding_;
  Consolidation consolidation_;
  StressReading reading_;
  SlideState state_;
};

}  // namespace flowslide
