// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <limits>
#include <vector>

#include "record/series.hpp"

namespace flowslide {

/// The course of a sample that is sheared at constant volume. A strain that is not reached is infinite.
struct Jam {
  /// First strain with sigma below 1 % of sigma_0.
  double liquefied_strain = std::numeric_limits<double>::infinity();
  /// The strain from which tau exceeds 1 % and 10 % of sigma_0 to the end.
  double strain_1 = std::numeric_limits<double>::infinity(), strain_10 = std::numeric_limits<double>::infinity();
  /// Largest tau after liquefaction and before `strain_10`, Pa: a burst that comes and goes.
  double largest_burst = 0.0;

  bool liquefies() const { return liquefied_strain < std::numeric_limits<double>::infinity(); }
  /// Whether tau stays above 10 % of sigma_0.
  bool jams() const { return strain_10 < std::numeric_limits<double>::infinity(); }
};

/// How long tau must exceed a level to the end of the test before it counts as staying there.
inline constexpr double lasting_strain = 0.25;

/// The course in the measured rows of an element test. `initial_normal_stress` is sigma_0, Pa. `lasts` states that the
/// test was ended because the sample bears a large stress: tau then counts as staying, however short the time.
Jam jam_of(const Series& rows, double initial_normal_stress, bool lasts);

/// The metrics of a course:
///   liquefied_strain, strain_above_1, strain_above_10   left out if not reached
///   jams             1 or 0
///   largest_burst    over sigma_0; left out without liquefaction
std::vector<Metric> metrics_of(const Jam& jam, double initial_normal_stress);

}  // namespace flowslide
