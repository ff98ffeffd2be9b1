// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <limits>

#include "coupling/slide.hpp"

namespace flowslide {

/// Conditions that end a slide; one of them suffices.
struct StopConditions {
  double end_time = 10.0;  ///< s
  double end_shear_strain = std::numeric_limits<double>::infinity();  ///< gamma of the layer
  /// The slide has stopped when v falls to 0 after it has exceeded this value, m/s. The threshold excludes oscillations
  /// on the elastic sample.
  double sliding_velocity = std::numeric_limits<double>::infinity();
  double end_velocity = std::numeric_limits<double>::infinity();  ///< v, m/s
};

enum class Stop { not_yet, end_time, end_shear_strain, end_velocity, sliding_stopped };

/// Throws std::invalid_argument unless all are > 0 and the end time is finite.
void validate(const StopConditions& conditions);

/// The condition that `state` meets, or `not_yet`. `time_step` is dt_G, s.
Stop stop_of(const SlideState& state, const StopConditions& conditions, double time_step);

}  // namespace flowslide
