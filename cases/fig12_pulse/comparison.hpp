// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <map>
#include <string>

#include "experiment/ensemble.hpp"

namespace flowslide {

/// Compares slides named "RD_..." and "RI_..." by the amplitude of their pulse. Adds these metrics to `metrics` if the
/// slides that they need have results:
///   parting_velocity.<statistic>  m/s, over the pairs of RD and RI on the same sample at 3 kPa that part (see
///                                 parting_velocity)
///   RD_normal_stress_over_RI      3 kPa: normal stress after the pulse, RD / RI, median over the samples
///   acceleration_gap              3 kPa: acceleration_share of RI - that of RD, lowest of the samples
///   RI_growth                     RI: v at x = 2 m / that of the next smaller amplitude on the same sample, median
///                                 over the samples; smallest of these ratios
///   RD_spread_over_amplitudes     m/s, RD: highest - lowest largest velocity of a sample over the amplitudes, mean
///                                 over the samples that all amplitudes use
///   RD_spread_over_seeds          m/s, RD: highest - lowest largest velocity of the samples, mean over amplitudes
///   RD_spread_ratio               RD_spread_over_amplitudes / RD_spread_over_seeds
void compare_schemes(const Ensembles& slides, std::map<std::string, double>& metrics);

/// The velocity of RI at which RD falls behind, m/s: v(x) of RI at the last x where the velocity of RD is at least 0.9
/// of it. The arguments are means over the displacement (see RunMeasures). NaN if RD is not behind at the end of the
/// shorter record, or if one of the records ends within 0.1 m.
double parting_velocity(const Series& rd, const Series& ri);

}  // namespace flowslide
