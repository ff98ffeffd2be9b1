// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <cmath>
#include <numbers>

#include "grains/measures.hpp"

namespace flowslide::testing {

/// Duration (s) of the undamped head-on impact of two equal spheres at the relative speed `impact_speed` (m/s, > 0):
/// t_H = 2 sqrt(pi) Gamma(7/5) / Gamma(9/10) overlap_max / speed (see hertz_impact_overlap).
/// Source: Hertz; Johnson, Contact Mechanics, ch. 11.
inline double hertz_contact_time(double radius, const Material& material, double impact_speed) {
  const double factor = 2.0 * std::sqrt(std::numbers::pi) * std::tgamma(1.4) / std::tgamma(0.9);
  return factor * hertz_impact_overlap(radius, material, impact_speed) / impact_speed;
}

}  // namespace flowslide::testing
