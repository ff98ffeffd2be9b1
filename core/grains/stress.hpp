// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "grains/assembly.hpp"
#include "grains/contact_forces.hpp"
#include "grains/material.hpp"
#include "grains/vector.hpp"

/// Homogenised stress of the whole cell. All tensors are compression positive with sigma_ij = (1/V) sum l_i f_j: the
/// first index is the direction of the branch (the normal of the section), the second that of the force.
namespace flowslide {

/// Bagi's stress, Pa (eq. 12). As printed:
///   <sigma>_B = 1/V [ sum_{c in I} l^c (x) f^c + sum_{e in E} l^e (x) f^e ].
/// As coded, compression positive:
///   sigma_B = 1/V [ sum_pairs (x_1 - x_2) (x) f_1 - sum_exterior (x_e - x_g) (x) f_e ],
/// with f_1 the force on the first grain, x_e the point at the boundary, and f_e the force of the boundary on grain g.
/// There are two kinds of exterior contacts:
/// (1) A mobile grain at a plane; x_e is the projection of its centre on the plane.
/// (2) A glued grain. The plane behind it holds it with minus the sum of its contact forces; x_e is the projection of
///     its centre on the plane z = lower or upper.
///
/// With (2), the z row needs no loop over pairs, in equilibrium and out of it:
///   sigma_z. = [ sum over mobile grains of z f - H F_top ] / V,
/// with z measured from the bottom plane, H the height of the cell, f the contact forces on a grain, and F_top the
/// force of the top boundary, layer and plane, on the mobile grains. Proof: let f be the force of a glued grain g on a
/// mobile grain p. The pair gives (z_p - z_g) f. The glue holds g with +f and gives -(z_e - z_g) f. The sum is (z_p -
/// z_e) f: z_p f at the bottom and (z_p - H) f at the top. A plane gives the same, and pairs of mobile grains give z_1
/// f_1 + z_2 f_2. Assumptions: the two layers do not touch each other, and x and y are periodic. The planes of a rigid
/// lateral axis push the grains but carry no stress on horizontal sections. If z is periodic, no grain is glued.
Matrix3 bagi_stress(const Assembly& assembly, const ContactForces& forces);

/// Second term of Nicot's stress, Pa (eq. 13). As printed, tension positive,
///   -1/V sum_p chi . [(omega . epsilon) + omega (x) omega - |omega|^2 I].
/// As coded, compression positive,
///   +1/V sum_p m R^2/5 [alpha . epsilon + omega (x) omega - |omega|^2 I],   (alpha . epsilon)_ij = alpha_k eps_kij,
/// because chi = (m R^2/5) I for a sphere. The dot of the first omega is missing in the paper: the term stems from the
/// acceleration alpha x r + omega x (omega x r) of the points of a rigid grain. It therefore contains the angular
/// acceleration alpha = T / I_s, with the torque of the assembly. It then cancels the antisymmetric part of Bagi's
/// stress, where sum r (x) f has the antisymmetric part epsilon . T / 2. Glued grains do not spin and contribute
/// nothing.
Matrix3 nicot_correction(const Assembly& assembly, const Material& material);

/// Nicot's stress, Pa (eq. 13): Bagi's stress plus `nicot_correction`.
Matrix3 nicot_stress(const Assembly& assembly, const ContactForces& forces, const Material& material);

/// Stress in the terms of the slope.
struct SlopeStress {
  double normal = 0.0;   ///< sigma, Pa, compression positive
  double shear = 0.0;    ///< tau, Pa, positive when the top drags the sample towards +x (downslope)
  double mean = 0.0;     ///< p, Pa, compression positive
};

/// From a compression-positive tensor: sigma = sigma_zz, tau = -sigma_zx, p = trace/3. The sign of tau: the top drags
/// an upper grain towards +x, and the lower grain holds it back. Thus l_z > 0 and f_x < 0, and sigma_zx < 0. The sign
/// of shear changes only here and in `stress_of` (dem/stress_sums.hpp).
SlopeStress slope_stress(const Matrix3& stress);

}  // namespace flowslide
