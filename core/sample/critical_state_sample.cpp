// SPDX-License-Identifier: GPL-2.0-or-later
#include "sample/critical_state_sample.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "grains/require.hpp"
#include "sample/failure.hpp"

namespace flowslide {
namespace {

/// Largest number of substeps in one call of `strain`. At the default substep this is a strain of 1000 % in one
/// exchange.
constexpr double most_substeps = 1e7;

void require_above_zero(const char* name, double value) {
  require(std::isfinite(value) && value > 0.0, fmt::format("{} of the critical-state sample", name), value, "> 0",
          "See CriticalStateProperties for values to start from.");
}

void require_not_negative(const char* name, double value) {
  require(std::isfinite(value) && value >= 0.0, fmt::format("{} of the critical-state sample", name), value, ">= 0",
          "Use 0 to leave this effect out.");
}

}  // namespace

CriticalStateSample::CriticalStateSample(const CriticalStateProperties& properties)
    : properties_(properties),
      normal_stress_(properties.normal_stress),
      stress_ratio_(properties.shear_stress / properties.normal_stress),
      void_ratio_(properties.void_ratio) {
  require_above_zero("critical friction", properties.critical_friction);
  require_above_zero("critical void ratio", properties.critical_void_ratio);
  require_above_zero("critical slope", properties.critical_slope);
  require_above_zero("reference stress", properties.reference_stress);
  require_above_zero("shear stiffness", properties.shear_stiffness);
  require_above_zero("oedometric stiffness", properties.oedometric_stiffness);
  require_above_zero("hardening", properties.hardening);
  require_not_negative("peak exponent", properties.peak_exponent);
  require_not_negative("dilatancy", properties.dilatancy);
  require_not_negative("dilatancy exponent", properties.dilatancy_exponent);
  require_above_zero("normal stress", properties.normal_stress);
  require_above_zero("void ratio", properties.void_ratio);
  require_above_zero("largest substep", properties.largest_substep);
  const double strength = properties.critical_friction * std::exp(-properties.peak_exponent * state_parameter());
  require(std::abs(stress_ratio_) < strength, "shear stress over normal stress of the critical-state sample",
          stress_ratio_, fmt::format("less than its strength {:.6g}", strength),
          "Make the slope flatter or the sample denser.");
}

double CriticalStateSample::state_parameter() const {
  const double critical = properties_.critical_void_ratio -
                          properties_.critical_slope * std::log(normal_stress_ / properties_.reference_stress);
  return void_ratio_ - critical;
}

CellStress CriticalStateSample::strain(const LocalRun& run) {
  validate(run);
  const double shear = run.rate.shear * run.duration(), compression = run.rate.compression * run.duration();
  const double substeps = std::ceil(std::max(std::abs(shear), std::abs(compression)) / properties_.largest_substep);
  if (!std::isfinite(shear + compression) || substeps > most_substeps)
    throw NumericalFailure(
        fmt::format("the critical-state sample is to follow a shear strain of {:.3g} and a compression of {:.3g} at "
                    "once, more than "
                    "{:.0e} of its substeps of {}; use a smaller time step dt_G",
                    shear, compression, most_substeps, properties_.largest_substep));
  for (double done = 0.0; done < substeps; ++done) substep(shear / substeps, compression / substeps);
  shear_strain_ += shear;
  return stress();
}

CellStress CriticalStateSample::stress() const {
  return {normal_stress_, stress_ratio_ * normal_stress_, 0.0, normal_stress_, normal_stress_};
}

SampleState CriticalStateSample::state() const {
  return {{{"normal_stress", normal_stress_},
           {"stress_ratio", stress_ratio_},
           {"void_ratio", void_ratio_},
           {"shear_strain", shear_strain_}},
          {}};
}

void CriticalStateSample::restore(const SampleState& state) {
  normal_stress_ = state.number("normal_stress");
  stress_ratio_ = state.number("stress_ratio");
  void_ratio_ = state.number("void_ratio");
  shear_strain_ = state.number("shear_strain");
}

void CriticalStateSample::substep(double shear, double compression) {
  // The equations are coded for tau >= 0 and divided by sigma; `sign` mirrors them for shear upslope.
  const bool upslope = stress_ratio_ < 0.0 || (stress_ratio_ == 0.0 && shear < 0.0);
  const double sign = upslope ? -1.0 : 1.0;
  const double ratio = sign * stress_ratio_, stiffness = properties_.shear_stiffness;
  const double bulk = properties_.oedometric_stiffness, state = state_parameter();
  const double drive = stiffness * sign * shear - ratio * bulk * compression;
  double ratio_change = drive, plastic_compression = 0.0;
  if (drive > 0.0) {
    const double dilatancy =
        properties_.dilatancy *
        (std::exp(properties_.dilatancy_exponent * state) - ratio / properties_.critical_friction);
    const double bounding = properties_.critical_friction * std::exp(-properties_.peak_exponent * state);
    const double hardening = properties_.hardening * stiffness * (bounding - ratio);
    const double resistance = hardening + ratio * (stiffness - ratio * bulk * dilatancy);
    if (!(resistance > 0.0))
      throw NumericalFailure(fmt::format(
          "the critical-state sample has no answer to shear at tau/sigma = {:.3g} and psi = {:.3g}: it would snap "
          "back; use a smaller dilatancy or hardening", ratio, state));
    ratio_change = hardening * drive / resistance;
    plastic_compression = dilatancy * ratio * drive / resistance;
  }
  stress_ratio_ += sign * ratio_change;
  normal_stress_ *= std::exp(bulk * (compression - plastic_compression));
  void_ratio_ = (1.0 + void_ratio_) * (1.0 - compression) - 1.0;
}

}  // namespace flowslide
