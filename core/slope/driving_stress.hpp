// SPDX-License-Identifier: GPL-2.0-or-later
// What drives a slope: its own weight, and on top of it a change of the shear stress in time. The driving normal stress
// sigma_d stays sigma_0 (eq. 9).
#pragma once
#include <limits>
#include <variant>
#include <vector>

#include "slope/statics.hpp"

namespace flowslide {

/// The weight alone.
struct NoChange {};

/// A constant rate, then held: change(t) = rate min(t, duration). The paper's triggering is 1e3 kPa/min (Fig. 8).
struct ConstantRate {
  double rate = 0.0;                                            ///< Pa/s
  double duration = std::numeric_limits<double>::infinity();    ///< s, > 0
};

/// change(t) = A sin(pi t/T) for t < T, and none from T on (paper, sec. 3.2).
struct SinePulse {
  double amplitude = 3e3;   ///< A, Pa
  double duration = 2.0;    ///< T, s, > 0
};

/// Straight lines between the points; the first and the last value hold before and after them.
struct StressTable {
  std::vector<double> time;    ///< s, each more than the one before
  std::vector<double> change;  ///< Pa, one per time
};

/// Change of the driving shear stress since the start; positive drives downslope.
using StressHistory = std::variant<NoChange, ConstantRate, SinePulse, StressTable>;

/// Throws std::invalid_argument if a value is not finite, a duration is not > 0 s, or a table is empty, unsorted or has
/// columns of different lengths.
void validate(const StressHistory& history);

/// The change at `time` (s, >= 0), Pa. `history` is taken as valid.
double stress_change(const StressHistory& history, double time);

/// tau_d = tau_0 + change, Pa, positive downslope, with tau_0 as in eq. 8.
class DrivingStress {
 public:
  /// Both are validated.
  DrivingStress(const SlopeProperties& slope, StressHistory history);

  double at(double time) const { return initial_ + stress_change(history_, time); }
  double initial() const { return initial_; }  ///< tau_0, Pa

 private:
  StressHistory history_;
  double initial_;
};

}  // namespace flowslide
