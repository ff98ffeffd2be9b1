// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <cstdint>

#include "sample/sample.hpp"

namespace flowslide {

/// A local time step dt_L that follows the stiffness of the contacts. The contacts of a liquefied sample are soft, and
/// a quasi-static slide passes most of its strain to such a sample. dt_L is chosen before an exchange, after every
/// `interval` local steps: the stable step of the sample, at least `smallest` and at most `largest`.
struct AdaptiveTimeStep {
  double smallest = 1e-5;        ///< s, > 0; the step that suits the stiffest contacts of the run
  double largest = 4e-5;         ///< s, >= smallest
  std::int64_t interval = 1500;  ///< local steps between two choices, >= 1; a choice costs about 60 steps
};

struct AdaptiveTimeStepState {
  double time_step = 0.0;    ///< dt_L in use, s; 0 before the first choice
  std::int64_t steps = 0;    ///< local steps since it was chosen
};

/// Throws std::invalid_argument if a value is out of its range.
void validate(const AdaptiveTimeStep& adaptive);

/// dt_L for the next run of the sample, s. Updates `state`.
double choose_time_step(const AdaptiveTimeStep& adaptive, Sample& sample, AdaptiveTimeStepState& state);

}  // namespace flowslide
