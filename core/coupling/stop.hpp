// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <limits>

#include "coupling/slide.hpp"

namespace flowslide {

/// When a slide has been followed far enough.
struct StopConditions {
  double end_time = 10.0;  ///< s
  double end_shear_strain = std::numeric_limits<double>::infinity();  ///< of the layer
  /// Sliding has stopped when v falls to 0 after it has exceeded this, m/s: swings on the elastic sample do not count.
  double sliding_velocity = std::numeric_limits<double>::infinity();
};

enum class Stop { not_yet, end_time, end_shear_strain, sliding_stopped };

/// Throws std::invalid_argument unless all are > 0 and the end time is finite.
void validate(const StopConditions& conditions);

/// Which condition is met in a state with steps of `time_step` (s).
Stop stop_of(const SlideState& state, const StopConditions& conditions, double time_step);

}  // namespace flowslide
