// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "slope/statics.hpp"

namespace flowslide {

/// C = 2k/(gamma_w (h_s cos theta)^2), 1/(Pa s), of eq. 5. The slope is validated.
double consolidation_coefficient(const SlopeProperties& slope);

/// How eq. 5 is integrated.
enum class ConsolidationScheme { euler, exponential };

/// Volumetric strain by drainage of the liquefiable layer, d(epsilon)/dt = C p_w (eq. 5), p_w = sigma_d - sigma the
/// excess pore pressure at the base. k = 0 integrates nothing.
///
/// euler, as printed: d_epsilon = dt C p_w with the stress that was last told. First order, stable up to
/// `consolidation_time_step_limit`.
///
/// exponential: the exact solution while a sample of oedometric modulus M answers d(sigma) = M d(epsilon),
///   d_epsilon = p_w/M [1 - exp(-C M dt)],  p_w = sigma_d - sigma - M epsilon_owed,
/// epsilon_owed the strain that the sample has not been given yet. It is exact for a constant M, for any dt and however
/// seldom the sample is asked. A sample of another modulus M_s is left with the share 1 - (M_s/M) [1 - exp(-C M dt)] of
/// p_w after a step: never below zero when M is an upper bound of M_s, so that any k and any dt are stable; it then
/// drains a little late, by the relative error C M dt/2 when that is small. So M is a bound of the stiffness of the
/// whole run, not an estimate that follows the sample: estimates from d(sigma)/d(epsilon) take the contraction by shear
/// for stiffness, and one that is too small is what makes a step unstable.
class Consolidation {
 public:
  /// `time_step` (s) and, for the exponential, `modulus` (Pa) are > 0; the slope is validated. Throws
  /// std::invalid_argument.
  Consolidation(const SlopeProperties& slope, ConsolidationScheme scheme, double time_step, double modulus);

  /// d_epsilon of one step, positive when the layer becomes thinner. `excess` is sigma_d - sigma, Pa.
  double increment(double excess, double owed_strain) const;

 private:
  double strain_per_excess_;  ///< d_epsilon over p_w, 1/Pa; 0 without drainage
  double predicted_modulus_;  ///< M, or 0 for euler, Pa
};

/// dt_G = 2/(M C), s, beyond which forward Euler for eq. 5 grows on a sample of modulus M (Pa); infinite for k = 0.
double consolidation_time_step_limit(const SlopeProperties& slope, double oedometric_modulus);

}  // namespace flowslide
