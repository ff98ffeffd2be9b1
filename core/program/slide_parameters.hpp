// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "program/slide_point.hpp"

namespace flowslide {

/// The parameters of a slide or element test, for its result. A parameter that it does not have is left out.
///   void_ratio                         1, the required one
///   hydraulic_conductivity, angle      m/s, rad
///   time_step, local_time_step         s, dt_G and dt_L
///   least_steps                        1, n_accum
///   inertial_number                    1, of the rate rule (`number`), or of a test at its initial normal stress
///   smallest_rate                      1/s, of RI
///   amplitude, duration                Pa, s, of a pulse
///   loading_rate, loading_duration     Pa/s, s, of a constant rate
///   shear_rate, final_strain           1/s, 1, of an element test
std::vector<Metric> parameters_of(const SlidePoint& point, const std::optional<double>& number);

/// "pulse of 3 kPa over 2 s", "16.7 kPa/s for 0.18 s", "constant load", "table of 5 points".
std::string describe(const StressHistory& loading);

}  // namespace flowslide
