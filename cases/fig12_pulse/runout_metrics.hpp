// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <vector>

#include "coupling/slide.hpp"
#include "record/series.hpp"

namespace flowslide {

/// The numbers that the claims about one slide are made of, from its record (see slide_series) and a pulse as loading.
/// One that the record does not have is not a number.
///   peak_shear_stress     Pa, largest tau up to 2 % strain
///   largest_velocity      m/s, largest mean of v over a tenth of a second
///   velocity_after_pulse  m/s, at t = T
///   final_velocity        m/s, mean over the last tenth of a second
///   final_displacement    m
///   acceleration_share    of the mean acceleration after the pulse in tau_d/m, that of a slope without resistance
///   liquefied_shear_stress, liquefied_normal_stress   Pa, mean tau and sigma after the pulse
std::vector<Metric> runout_metrics(const Series& series, const SlideSettings& settings);

/// Mean velocity within a twentieth of a second on either side of `time`, m/s; NaN if the record ends before that.
double velocity_at(const Series& series, double time);

}  // namespace flowslide
