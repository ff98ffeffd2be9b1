// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "sample/sample.hpp"

namespace flowslide {

/// tau and sigma as the slope is told them, Pa.
struct BasalStress {
  double shear = 0.0;   ///< tau, positive downslope
  double normal = 0.0;  ///< sigma, effective, compression positive
};

/// What becomes of the residual of a prepared sample: the difference between the stresses in equilibrium with the slope
/// (eqs 8 and 9) and those that the servo reached.
enum class ResidualTreatment {
  left_out,  ///< absolute stress: the slope starts out of balance by the residual
  fades,            ///< added in proportion to the normal stress left: balance at the start, 0 where it liquefies
  stays             ///< stress increments as in step 8 of Algorithm 1: balance at the start, but the residual stays for
                    ///< ever, so that a liquefied sample shows it as strength
};

/// Turns the stress of the sample into that of the slope.
class StressReading {
 public:
  /// `balance` is in equilibrium with the slope, `prepared` the stress of the sample before it is strained. Unless the
  /// residual stays, where any sample will do, throws NumericalFailure if it exceeds `largest_residual` of the normal
  /// stress, or the normal stress is not positive.
  StressReading(ResidualTreatment treatment, const BasalStress& balance, const CellStress& prepared);

  BasalStress read(const CellStress& sample) const;
  BasalStress residual() const { return residual_; }

 private:
  ResidualTreatment treatment_;
  BasalStress residual_;
  double prepared_normal_;
};

/// A servo ends within some percent; a sample that is further off was prepared for another slope.
inline constexpr double largest_residual = 0.05;

}  // namespace flowslide
