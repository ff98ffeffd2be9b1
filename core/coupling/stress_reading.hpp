// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "sample/sample.hpp"

namespace flowslide {

/// Resisting stresses at the base of the slope, Pa.
struct BasalStress {
  double shear = 0.0;   ///< tau, positive downslope
  double normal = 0.0;  ///< sigma, effective, compression positive
};

/// How the slope treats the residual of a prepared sample: the difference between the stresses in equilibrium with the
/// slope (eqs 8 and 9) and the stresses that the servo reached.
enum class ResidualTreatment {
  left_out,  ///< absolute stress of the sample: the slope starts out of balance by the residual
  fades,     ///< the residual is added in proportion to sigma: balance at the start, no residual at liquefaction
  stays      ///< stress increments as in step 8 of Algorithm 1: balance at the start, but the residual remains and
             ///< appears as strength of a liquefied sample
};

/// Converts the stress of the sample into the stress at the base of the slope.
class StressReading {
 public:
  /// `balance` is the stress in equilibrium with the slope. `prepared` is the stress of the sample before it is
  /// strained. Throws NumericalFailure if the residual exceeds the fraction `largest_residual` of the normal stress of
  /// `balance`, or if the normal stress of `prepared` is not positive. `stays` accepts any sample.
  StressReading(ResidualTreatment treatment, const BasalStress& balance, const CellStress& prepared);

  BasalStress read(const CellStress& sample) const;
  BasalStress residual() const { return residual_; }

 private:
  ResidualTreatment treatment_;
  BasalStress residual_;
  double prepared_normal_;
};

/// A servo ends within some percent of its target. A sample with a larger residual was prepared for another slope.
inline constexpr double largest_residual = 0.05;

}  // namespace flowslide
