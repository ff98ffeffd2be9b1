// SPDX-License-Identifier: GPL-2.0-or-later
#include "coupling/slide.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <variant>

#include "grains/require.hpp"
#include "sample/failure.hpp"

namespace flowslide {
namespace {

/// Larger values count as not finite. No slope reaches this value, and sums of smaller values in a record stay finite.
constexpr double finite_limit = 1e100;

}  // namespace

void validate(const SlideSettings& settings) {
  validate(settings.loading);
  Sliding(settings.slope, settings.time_step);
  Consolidation(settings.slope, settings.consolidation, settings.time_step, settings.oedometric_modulus);
  validate(settings.rate);
  validate(settings.passing);
  if (settings.adaptive) validate(*settings.adaptive);
  if (settings.rest) validate(*settings.rest);
  require(settings.stress_interval >= 1, "number of runs of the sample per measured stress",
          static_cast<double>(settings.stress_interval), "1 or more", "Use 1 to measure after each.");
  if (const auto* pulse = std::get_if<SinePulse>(&settings.loading))
    require(pulse->duration >= (1.0 - 1e-9) * least_steps_of_pulse * settings.time_step,
            "duration of the pulse in dt_G", pulse->duration / settings.time_step, "at least 10",
            "Use a smaller dt_G: it sees only a part of this pulse.");
  require(std::isfinite(settings.initial_velocity), "initial velocity", settings.initial_velocity,
          "any finite value in m/s", "Use 0 to start at rest.");
}

Slide::Slide(const SlideSettings& settings, Sample& sample)
    : settings_(settings),
      sample_(sample),
      driving_(settings.slope, settings.loading),
      driving_normal_stress_(initial_normal_stress(settings.slope)),
      sliding_(settings.slope, settings.time_step),
      consolidation_(settings.slope, settings.consolidation, settings.time_step, settings.oedometric_modulus),
      reading_(settings.residual, {driving_.initial(), driving_normal_stress_}, sample.stress()) {
  validate(settings);
  state_.driving_stress = driving_.at(0.0);
  state_.stress = reading_.read(sample.stress());
  state_.velocity = state_.largest_velocity = settings.initial_velocity;
  state_.sliding = sliding_.start(settings.initial_velocity, state_.driving_stress, state_.stress.shear);
}

void Slide::step() {
  const double height = settings_.slope.liquefiable_thickness;
  const Strain increment{sliding_.move(state_.sliding) / height,
                         consolidation_.increment(basal_pore_pressure(), state_.owed.compression)};
  state_.strain += increment;
  state_.global_rate = increment.norm() / settings_.time_step;
  // sigma stands for p: grains wedged between the glued layers keep the mean stress of the cell up after sigma
  // vanishes.
  state_.rate_asked = rate_asked(settings_.rate, state_.global_rate, sample_.stress().normal, state_.strain.shear);
  const bool resting =
      settings_.rest && rests(*settings_.rest, state_.rest, increment.norm(), sample_.stress().normal);
  run_sample(resting ? LocalRun{} : pass(passing(), state_.owed, increment, state_.rate_asked));

  ++state_.exchanges;
  state_.time = static_cast<double>(state_.exchanges) * settings_.time_step;
  state_.driving_stress = driving_.at(state_.time);
  state_.velocity = sliding_.accelerate(state_.sliding, state_.driving_stress, state_.stress.shear);
  state_.largest_velocity = std::max(state_.largest_velocity, state_.velocity);
  check_finite();
}

void Slide::check_finite() const {
  const auto sound = [](double value) { return std::abs(value) < finite_limit; };
  if (sound(state_.velocity) && sound(state_.sliding.displacement) && sound(state_.strain.norm()) &&
      sound(state_.stress.shear) && sound(state_.stress.normal))
    return;
  throw NumericalFailure(
      fmt::format("the slide is not finite at t = {} s: v = {} m/s, tau = {} Pa, sigma = {} Pa; use a "
                  "smaller time step than dt_G = {} s",
                  state_.time, state_.velocity, state_.stress.shear, state_.stress.normal, settings_.time_step));
}

/// The passing rule with the present dt_L.
StrainPassing Slide::passing() {
  StrainPassing present = settings_.passing;
  if (settings_.adaptive) present.time_step = choose_time_step(*settings_.adaptive, sample_, state_.adaptive);
  return present;
}

void Slide::run_sample(LocalRun run) {
  state_.steps = run.steps;
  if (run.steps == 0) return;
  run.measured = ++state_.unmeasured_runs >= settings_.stress_interval;
  const CellStress stress = sample_.strain(run);
  if (run.measured) {
    state_.stress = reading_.read(stress);
    state_.unmeasured_runs = 0;
  }
  state_.rate_applied = Strain{run.rate.shear, run.rate.compression}.norm();
  state_.local_time += run.duration();
  state_.local_steps += run.steps;
  state_.adaptive.steps += run.steps;
}

}  // namespace flowslide
