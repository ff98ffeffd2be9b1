// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <vector>

#include "program/slide_case.hpp"

namespace flowslide {

/// The numbers of one slide beside those of its runout (see pulse_runout). One that it does not have is not a number:
/// what is said of the time after the pulse needs a pulse as loading.
///   final_velocity        m/s, mean over the last tenth of a second
///   acceleration_share    of the mean acceleration after the pulse in tau_d/m, that of a slope without resistance
///   liquefied_shear_stress, liquefied_normal_stress   Pa, mean tau and sigma after the pulse
std::vector<Metric> after_pulse(const SlideOutcome& outcome);

}  // namespace flowslide
