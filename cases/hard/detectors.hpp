// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "dem/engine.hpp"

namespace flowslide {

/// What a code without any check would have computed at a time step, and which detectors would have raised an alarm.
struct PlainRun {
  double peak = 0.0;             ///< largest shear stress, Pa
  double largest_share = 0.0;    ///< of time_step_share, over all looks
  bool lost = false;             ///< a grain is outside the cell, or a stress is not finite
  bool stiffness_alarm = false;  ///< share of 1 or more at a look: see check_contact_time_step
  bool overlap_alarm = false;    ///< see check_assembly
  bool rest_alarm = false;    ///< held still for 3000 steps, the sample has more than ten times the kinetic energy of
                              ///< a prepared one
  bool energy_alarm = false;  ///< kinetic and spring energy have grown by more than the top layer's work
};

/// Shears a prepared sample from the linear velocity field, without a check.
PlainRun plain_run(Engine& engine, const Assembly& sample, const EngineSettings& settings, double rate, double strain,
                   int looks);

}  // namespace flowslide
