// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <map>
#include <string>

#include "program/runout.hpp"

namespace flowslide {

/// Bounds of the conductivity k above which a slope does not stay liquefied, m/s. The criterion is v at the end of the
/// pulse. Up to `lower` it differs from its value at k = 0 by at most half of that value, from `upper` on by more. A
/// bound that the sweep does not reach is NaN; both are NaN without k = 0.
struct CriticalConductivity {
  double lower, upper;
};

/// The bounds for one sample: the sample of `first`, a result of the first member of the sweep (see paired).
CriticalConductivity critical_conductivity(const std::vector<SweepMember>& sweep, const Result& first);

/// Compares slides named "RD_..." and "RI_..." by their parameter hydraulic_conductivity, k. Adds these metrics to
/// `metrics`; NaN, or none, if the slides that they need have no results:
///   RD_velocity_order, RD_runout_order   RD: rank correlation of k with the median v_max, and with the median runout
///   critical_conductivity_lower, _upper  m/s, RI: the lowest and the highest bound of all samples
///   critical_conductivity                m/s, RI: median over the samples of the geometric mean of the two bounds (the
///                                        values of k are spaced geometrically): 0 for a sample that the smallest k > 0
///                                        changes, infinite for one that no k changes. No metric if the median is
///                                        infinite.
///   RI_change_below                      RI: largest relative change of the median v at the end of the pulse from its
///                                        value at k = 0, over 0 < k < critical_conductivity
///   RI_stopped_above                     RI: smallest fraction of the samples that stand at the end, over all
///                                        k >= critical_conductivity_upper
void compare_conductivities(const Ensembles& slides, std::map<std::string, double>& metrics);

/// The critical conductivity of RI and its two bounds, as a table with one row. Without rows if one of them does not
/// exist.
Series critical_series(const Ensembles& slides);

}  // namespace flowslide
