// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <cstdint>
#include <optional>

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

/// Everything that determines a slide but its sample.
struct SlideSettings {
  SlopeProperties slope;
  StressHistory loading;
  double time_step = 1e-4;           ///< dt_G, s
  ConsolidationScheme consolidation = ConsolidationScheme::exponential;
  double oedometric_modulus = 1e8;   ///< upper bound of the sample's M, Pa; for the exponential alone
  RateRule rate;
  StrainPassing passing;
  ResidualTreatment residual = ResidualTreatment::fades;
  double initial_velocity = 0.0;     ///< v^0, m/s
  std::int64_t stress_interval = 1;  ///< the stress is measured after every n-th run of the sample, and held between
  std::optional<LiquefiedRest> rest;  ///< none: the sample is given all strain
};

/// Everything that changes while a slope slides, but its sample: storing and restoring it (and the sample) goes on bit
/// for bit.
struct SlideState {
  std::int64_t exchanges = 0;       ///< global steps done
  double time = 0.0;                ///< t, the global clock, s
  SlidingState sliding;             ///< x at t and v at t + dt_G/2
  double velocity = 0.0;            ///< v at t, m/s
  double largest_velocity = 0.0;    ///< of all exchanges, m/s
  Strain strain;                    ///< of the layer, since the start
  Strain owed;                      ///< the part of it that has not been passed to the sample: eps_accum
  double driving_stress = 0.0;      ///< tau_d at t, Pa
  BasalStress stress;               ///< tau and sigma at t, of the strain that has been passed
  double global_rate = 0.0;         ///< ||d(epsilon_G)||/dt_G of the last step, 1/s
  double rate_asked = 0.0;          ///< eps_L^U of the last step, 1/s
  double rate_applied = 0.0;        ///< to the sample the last time that it ran, 1/s
  std::int64_t steps = 0;           ///< n_step of the last step; 0 while strain accumulates
  std::int64_t unmeasured_runs = 0;  ///< of the sample since its stress was measured
  RestState rest;                   ///< of a sample that may rest when liquefied
  double local_time = 0.0;          ///< the local clock, s
  std::int64_t local_steps = 0;     ///< of all exchanges
};

/// A pulse must last at least so many global steps: the slope sees it at the exchanges alone, where the impulse of a
/// sine over n steps is short by (pi/n)^2/12, 0.8 % of it for 10, and all of it for one.
inline constexpr double least_steps_of_pulse = 10.0;

/// Throws std::invalid_argument if a setting is out of its range, or a pulse is shorter than `least_steps_of_pulse`.
/// Stability is the caller's: see sliding_time_step_limit and consolidation_time_step_limit.
void validate(const SlideSettings& settings);

/// A slope on its sample: Algorithm 1, every exchange the same on all ranks that share the sample.
///
/// As printed, with v at half steps: x += dt v; epsilon by eq. 5; (gamma, epsilon) to the sample; its stress back;
/// a = (tau_d - tau)/m; v += dt a. The driving normal stress sigma_d is sigma_0. How the increments of stress in step 8
/// are taken, see ResidualTreatment. Second order in dt_G without drainage on a sample that knows no rate and is asked
/// at every step; first order with forward Euler, with a sample that knows its rate, and while strain accumulates: a
/// stress that is held for a time t_h acts half of it late, and drives a swing of frequency omega on, by the factor
/// exp(omega^2 t_h t/4). dt_G >= n_accum dt_L avoids that at the rate of the slope.
class Slide {
 public:
  /// Begins at rest or at the initial velocity. `sample` must outlive it. Throws as `validate`, and NumericalFailure if
  /// the sample does not suit the slope.
  Slide(const SlideSettings& settings, Sample& sample);

  /// One global step dt_G. Throws NumericalFailure, also when the slide is no longer finite.
  void step();

  const SlideState& state() const { return state_; }
  /// Goes on from a state that a slide of the same settings has had; the sample is the caller's.
  void restore(const SlideState& state) { state_ = state; }

  /// sigma_d - sigma, the excess pore pressure at the base, Pa.
  double basal_pore_pressure() const { return driving_normal_stress_ - state_.stress.normal; }
  const SlideSettings& settings() const { return settings_; }
  const StressReading& reading() const { return reading_; }
  const Sample& sample() const { return sample_; }

 private:
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
