// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <vector>

#include "program/slide_case.hpp"

namespace flowslide {

/// Metrics of one slide. NaN for a metric that the slide does not have. Metrics about the time after the pulse need a
/// pulse as loading.
///   peak_shear_stress     Pa, largest tau up to 2 % strain
///   largest_velocity      m/s, largest mean of v over 0.1 s
///   velocity_after_pulse  m/s, mean of v over 0.1 s centred at the end of the pulse
///   final_velocity        m/s, mean of v over the last 0.1 s
///   final_displacement    m, at the end
///   acceleration_share    1, mean acceleration after the pulse / (tau_0/m), that of a slope without resistance
///   liquefied_shear_stress, liquefied_normal_stress   Pa, mean tau and sigma after the pulse
std::vector<Metric> runout_metrics(const SlideOutcome& outcome);

}  // namespace flowslide
