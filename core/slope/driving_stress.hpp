// SPDX-License-Identifier: GPL-2.0-or-later
// The driving shear stress of a slope: the static stress of its weight plus a prescribed change in time. The driving
// normal stress sigma_d stays sigma_0 (eq. 9).
#pragma once
#include <limits>
#include <variant>
#include <vector>

#include "slope/statics.hpp"

namespace flowslide {

/// No change: the weight alone drives the slope.
struct NoChange {};

/// A constant rate, held after `duration`: change(t) = rate min(t, duration). The paper triggers the slope at
/// 1e3 kPa/min (Fig. 8).
struct ConstantRate {
  double rate = 0.0;                                            ///< Pa/s
  double duration = std::numeric_limits<double>::infinity();    ///< s, > 0
};

/// A pulse: change(t) = A sin(pi t/T) for t < T, and 0 from T on (paper, sec. 3.2).
struct SinePulse {
  double amplitude = 3e3;   ///< A, Pa
  double duration = 2.0;    ///< T, s, > 0
};

/// Linear interpolation between rows. The first value holds before the table, the last value after it.
struct StressTable {
  std::vector<double> time;    ///< s, strictly increasing
  std::vector<double> change;  ///< Pa, one per time
};

/// Change of the driving shear stress since the start, Pa; positive drives downslope.
using StressHistory = std::variant<NoChange, ConstantRate, SinePulse, StressTable>;

/// Throws std::invalid_argument if a value is not finite, a duration is not > 0 s, or a table is empty, unsorted or has
/// columns of different lengths.
void validate(const StressHistory& history);

/// The change at `time` (s, >= 0), Pa. Precondition: `history` is valid.
double stress_change(const StressHistory& history, double time);

/// tau_d = tau_0 + change, Pa, positive downslope, with tau_0 from eq. 8.
class DrivingStress {
 public:
  /// Throws as `validate` of the slope and of the history.
  DrivingStress(const SlopeProperties& slope, StressHistory history);

  double at(double time) const { return initial_ + stress_change(history_, time); }  ///< tau_d at `time` (s), Pa
  double initial() const { return initial_; }  ///< tau_0, Pa

 private:
  StressHistory history_;
  double initial_;
};

}  // namespace flowslide
