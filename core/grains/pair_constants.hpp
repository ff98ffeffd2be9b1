// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <cmath>

namespace flowslide {

struct Material;

/// Constants of the contact law for a pair of spheres of the same material.
struct PairConstants {
  double radius_first = 0.0, radius_second = 0.0;  ///< R_1, R_2, m
  double effective_radius = 0.0;         ///< R* = R_1 R_2 / (R_1 + R_2), m
  double effective_mass = 0.0;           ///< m* = m_1 m_2 / (m_1 + m_2), kg
  double effective_modulus = 0.0;        ///< Y* = E / (2 (1 - nu^2)), Pa
  double effective_shear_modulus = 0.0;  ///< G* = E / (4 (2 - nu) (1 + nu)), Pa
  double damping = 0.0;                  ///< beta = ln e / sqrt(ln^2 e + pi^2), in (-1, 0]
  double rolling_inertia = 0.0;          ///< I_r = 7/5 J_1 J_2 / (J_1 + J_2) with J = m R^2, kg m^2
};

/// Mass (kg) of a sphere of `radius` (m).
double sphere_mass(double radius, const Material& material);

/// Moment of inertia I_s = 2/5 m R^2 (kg m^2) of a sphere about an axis through its centre.
double sphere_inertia(double radius, const Material& material);

/// Constants of two touching spheres.
PairConstants pair_constants(const Material& material, double radius_first, double radius_second);

/// Constants of a sphere at a plane of the same material: R* = R, m* = m, I_r = 7/5 m R^2.
PairConstants plane_constants(const Material& material, double radius);

/// gamma over sqrt(S m*), 1.
inline double dashpot_coefficient(const PairConstants& pair) { return -2.0 * std::sqrt(5.0 / 6.0) * pair.damping; }

}  // namespace flowslide
