// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <map>
#include <string>

#include "experiment/ensemble.hpp"

namespace flowslide {

/// Adds to `metrics` what is said of several slides, named "RD_..." and "RI_...", by the amplitude of their pulse,
/// where those needed have been run:
///   parting_velocity.<statistic>  m/s, of the pairs by RI and RD on one sample at 3 kPa (see parting_velocity)
///   RD_normal_stress_over_RI      ratio of the medians of the normal stress after the pulse at 3 kPa
///   acceleration_gap              lowest acceleration_share of RI less the highest of RD at 3 kPa
///   RI_growth                     least ratio of the medians of v at equal x of neighbouring amplitudes, by RI
///   RD_spread_over_amplitudes     m/s, highest less lowest of the median largest velocities, by RD
///   RD_spread_over_seeds          m/s, mean over the amplitudes of highest less lowest largest velocity
///   RD_spread_ratio               the former over the latter
void compare_schemes(const Ensembles& slides, std::map<std::string, double>& metrics);

/// From windows over the displacement: the velocity by RI up to which RD follows: v(x) at the last x where RD's is not
/// below it by more than a tenth, m/s. The largest v of RI that RD has reached the place of, if they never part; NaN if
/// one of them stops within 0.1 m.
double parting_velocity(const Series& rd, const Series& ri);

}  // namespace flowslide
