// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <vector>

#include "experiment/run_measures.hpp"

namespace flowslide {

/// The numbers that the claims about one slide are made of. One that it does not have is not a number.
///   peak_shear_stress, strain_at_peak           Pa and 1: the largest tau up to 5 % strain, the point of instability
///   time_at_peak, normal_stress_at_peak         s and Pa: there
///   largest_inertial_number_before_peak         1: of the rate of the slope, with p as measured every half millisecond
///   lowest_normal_stress                        Pa: up to 50 % strain
///   steady_shear, steady_normal                 Pa: means over strain beyond 50 %, where the paper sees a steady state
///   steady_friction                             1: mu_ss = steady_shear/steady_normal
///   steady_inertial_number                      1: mean I of the rate of the slope beyond 50 %
///   steady_applied_inertial_number              1: mean I of the rate that the sample was sheared at
///   final_velocity                              m/s
/// `final_velocity` is that of the last row, m/s.
std::vector<Metric> trigger_metrics(const RunMeasures& measures, double final_velocity);

/// Friction tau/sigma over windows of shear strain up to `friction_until`, from windows over strain: in each, the mean
/// of tau over that of sigma, since the quotient of single moments has no mean where sigma falls to nothing.
Series friction(const Series& over_strain);

/// Shear strain beyond which the paper takes the state for steady (Fig. 9).
inline constexpr double steady_from = 0.5;
inline constexpr double friction_until = 1.5;

}  // namespace flowslide
