// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <map>
#include <string>

#include "program/runout.hpp"

namespace flowslide {

/// Where along a sweep of k the slope leaves liquefaction, m/s: v at the end of the pulse is at least half of that at
/// k = 0 up to `lower`, and less from `upper` on. NaN where the sweep does not reach so far, or has no k = 0.
struct CriticalConductivity {
  double lower, upper;
};

/// That of one sample: of the one that `first`, a result of the first member, was run on (see paired).
CriticalConductivity critical_conductivity(const std::vector<SweepMember>& sweep, const Result& first);

/// Adds to `metrics` what is said of slides named "RD_..." and "RI_..." by their parameter hydraulic_conductivity, k;
/// what was not run is not a number:
///   RD_velocity_order, RD_runout_order   rank correlations of k with the medians of v_max and of the runout, by RD
///   critical_conductivity_lower, _upper  m/s, of RI: the lowest and the highest bound of all samples
///   critical_conductivity                m/s, median of the samples; of each the geometric mean of its bounds, as the
///                                        sweep is spaced
///   RI_change_below                      largest change of the median v at the end of the pulse against k = 0, by RI,
///                                        over 0 < k < critical_conductivity
///   RI_stopped_above                     least share of the samples that stop, by RI, over all
///                                        k > critical_conductivity_upper
void compare_conductivities(const Ensembles& slides, std::map<std::string, double>& metrics);

/// The critical conductivity of RI and its two bounds as a table of one row; of none if there is none.
Series critical_series(const Ensembles& slides);

}  // namespace flowslide
