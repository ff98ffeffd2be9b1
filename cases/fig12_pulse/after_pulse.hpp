// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <vector>

#include "program/slide_case.hpp"

namespace flowslide {

/// Metrics of one slide beside those of pulse_runout. NaN for a metric that the slide does not have. Metrics about the
/// time after the pulse need a pulse as loading.
///   final_velocity        m/s, mean of v over the last 0.1 s
///   acceleration_share    1, mean acceleration after the pulse / (tau_0/m), that of a slope without resistance
///   liquefied_shear_stress, liquefied_normal_stress   Pa, mean tau and sigma after the pulse
std::vector<Metric> after_pulse(const SlideOutcome& outcome);

}  // namespace flowslide
