// SPDX-License-Identifier: GPL-2.0-or-later
//
// What the parts of a contact law read in the form that steps the grains: one contact of a tile, without a branch.
#pragma once
#include "grains/laws/fused.hpp"
#include "grains/laws/roots.hpp"

namespace flowslide::laws {

/// One contact. The overlap and the scales of an open pair are 0, which makes stiffnesses, dashpots and caps exactly 0.
template <typename Real>
struct Lane {
  Components<Real> normal;                                            ///< n, from the second centre to the first
  Real overlap;                                                       ///< delta, m
  Real scale, root_scale;                                             ///< s and sqrt(s), see StiffnessConstants
  Real effective_radius, root_effective_mass, root_rolling_inertia;   ///< R*, sqrt(m*), sqrt(I_r)
  Components<Real> velocity;                                          ///< v_1 - v_2, m/s
  Real separation_velocity;                                           ///< v_n = (v_1 - v_2) . n, m/s
  Components<Real> surface_spin;                                      ///< c_1 w_1 + c_2 w_2, m/s
  Components<Real> relative_spin;                                     ///< w_1 - w_2, rad/s
  Real time_step;                                                     ///< dt_L, s
};

/// Springs and dashpots of a normal part. It defines the scale s of a contact (m for Hertz, 1 for a constant
/// stiffness), so that k_n = normal s, gamma_n = normal_damping sqrt(s m*), and likewise tangential.
template <typename Real>
struct StiffnessConstants {
  Real normal, normal_damping;
  Real tangential, tangential_damping;
  Real lowest_force;  ///< F_n is not below this, N: 0, or the lowest number
};

/// F_n = k_n delta - gamma_n v_n, N, or `lowest_force` if that is larger. Not a number stays what it is.
template <typename Real>
FLOWSLIDE_LANE Real spring_and_dashpot(const StiffnessConstants<Real>& c, const Lane<Real>& contact) {
  const Real force = difference_of_products(c.normal * contact.scale, contact.overlap,
                                            c.normal_damping * (contact.root_scale * contact.root_effective_mass),
                                            contact.separation_velocity);
  return force < c.lowest_force ? c.lowest_force : force;
}

}  // namespace flowslide::laws
