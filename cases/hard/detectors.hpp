// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "dem/engine.hpp"
#include "experiments.hpp"

namespace flowslide {

/// The result of a run without any check of the time step, and the alarms that each detector would have raised.
struct UncheckedRun {
  double peak = 0.0;             ///< largest shear stress, Pa
  double largest_share = 0.0;    ///< largest time_step_share of all readings
  bool lost = false;             ///< a grain is outside the cell, or a stress is not finite
  bool stiffness_alarm = false;  ///< largest_share >= 1: see check_contact_time_step
  bool overlap_alarm = false;    ///< see check_assembly
  bool rest_alarm = false;    ///< after 3000 steps at rest the kinetic number is not below ten times the tolerance of
                              ///< a preparation
  bool energy_alarm = false;  ///< kinetic and spring energy grew by more than the work of the top layer and 5 %
};

/// Shears a prepared sample from a linear velocity field, without a check of the time step. The detectors examine the
/// sample at the readings of `shearing`.
UncheckedRun run_unchecked(Engine& engine, const Assembly& sample, const EngineSettings& settings,
                           const Shearing& shearing);

}  // namespace flowslide
