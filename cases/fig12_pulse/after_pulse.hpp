// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <vector>

#include "program/slide_case.hpp"

namespace flowslide {

/// The numbers that the claims about one slide are made of. One that it does not have is not a number: what is said of
/// the time after the pulse needs a pulse as loading.
///   peak_shear_stress     Pa, largest tau up to 2 % strain
///   largest_velocity      m/s, largest mean of v over a tenth of a second
///   velocity_after_pulse  m/s, at t = T
///   final_velocity        m/s, mean over the last tenth of a second
///   final_displacement    m
///   acceleration_share    of the mean acceleration after the pulse in tau_d/m, that of a slope without resistance
///   liquefied_shear_stress, liquefied_normal_stress   Pa, mean tau and sigma after the pulse
std::vector<Metric> runout_metrics(const SlideOutcome& outcome);

}  // namespace flowslide
