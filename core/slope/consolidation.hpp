// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "slope/statics.hpp"

namespace flowslide {

/// C = 2k/(gamma_w (h_s cos theta)^2), 1/(Pa s), from eq. 5. Throws as `validate`.
double consolidation_coefficient(const SlopeProperties& slope);

/// How eq. 5 is integrated.
enum class ConsolidationScheme { euler, exponential };

/// Volumetric strain of the liquefiable layer by drainage: d(epsilon)/dt = C p_w (eq. 5). The excess pore pressure at
/// the base is p_w = sigma_d - sigma. With k = 0 every increment is 0.
///
/// euler: eq. 5 as printed, d_epsilon = C p_w dt, with the last measured stress. It is of first order in dt and stable
/// up to `consolidation_time_step_limit`.
///
/// exponential: the exact solution for a sample of constant oedometric modulus M, d(sigma) = M d(epsilon):
///   d_epsilon = p_w/M [1 - exp(-C M dt)],  p_w = sigma_d - sigma - M epsilon_owed.
/// epsilon_owed is the strain that has not been passed to the sample yet. The solution is exact for any dt and for any
/// number of steps between two runs of the sample.
///
/// With a sample of another modulus M_s, a step leaves the fraction 1 - (M_s/M) [1 - exp(-C M dt)] of p_w. If M is an
/// upper bound of M_s, this fraction is never negative, and the scheme is stable for any k and dt. The sample then
/// drains slightly late: the relative error is C M dt/2 if this number is small.
/// M must therefore bound the stiffness during the whole run. Estimates from d(sigma)/d(epsilon) take contraction by
/// shear for stiffness, and an estimate that is too small makes a step unstable.
class Consolidation {
 public:
  /// `time_step` is dt_G (s, > 0). `modulus` is M (Pa, > 0); only `exponential` uses it. Throws std::invalid_argument
  /// if one of them or the slope is invalid.
  Consolidation(const SlopeProperties& slope, ConsolidationScheme scheme, double time_step, double modulus);

  /// d_epsilon of one step, positive when the layer becomes thinner. `excess` is sigma_d - sigma (Pa), `owed_strain` is
  /// epsilon_owed.
  double increment(double excess, double owed_strain) const;

 private:
  double strain_per_excess_;  ///< d_epsilon/p_w, 1/Pa; 0 without drainage
  double predicted_modulus_;  ///< M, Pa; 0 for euler
};

/// Largest stable time step of `euler` on a sample of oedometric modulus M (Pa, > 0): dt_G = 2/(M C), s. Infinite for
/// k = 0. Throws std::invalid_argument.
double consolidation_time_step_limit(const SlopeProperties& slope, double oedometric_modulus);

}  // namespace flowslide
