// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <vector>

#include "experiment/run_measures.hpp"

namespace flowslide {

/// Metrics of one slide. NaN for a metric that the slide does not have. `final_velocity` (m/s) is that of the last row.
///   peak_shear_stress, strain_at_peak           Pa and 1, largest tau up to 5 % strain: the point of instability
///   time_at_peak, normal_stress_at_peak         s and Pa, at this peak
///   largest_inertial_number_before_peak         1, of the rate of the slope; p is measured every 0.5 ms
///   lowest_normal_stress                        Pa, up to 50 % strain
///   steady_shear, steady_normal                 Pa, means over strain beyond 50 %: the steady state of the paper
///   steady_friction                             1, mu_ss = steady_shear/steady_normal
///   steady_inertial_number                      1, mean I at the rate of the slope beyond 50 % strain
///   steady_applied_inertial_number              1, mean I at the rate applied to the sample beyond 50 % strain
///   final_velocity                              m/s
std::vector<Metric> trigger_metrics(const RunMeasures& measures, double final_velocity);

/// Friction tau/sigma over the shear strain up to `friction_until`. Each value is the mean of tau / the mean of sigma
/// in one window of strain. The mean of tau/sigma does not exist where sigma falls to 0. `over_strain`: see
/// RunMeasures.
Series friction(const Series& over_strain);

/// Shear strain beyond which the paper considers the state as steady (Fig. 9).
inline constexpr double steady_from = 0.5;
inline constexpr double friction_until = 1.5;

}  // namespace flowslide
