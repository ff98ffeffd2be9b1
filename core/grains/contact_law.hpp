// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "grains/cap.hpp"
#include "grains/material.hpp"
#include "grains/pair_constants.hpp"
#include "grains/vector.hpp"

/// The contact law of LIGGGHTS 3.8 (`hertz`, `tangential history`, `rolling_friction epsd3`, `limitForce off`,
/// `torsionTorque off`, `tangential_damping on`) as plain functions. Sources: Hertz; Mindlin without slip;
/// Tsuji et al. 1992 for the dashpots; Ai et al. 2011 for the rolling model.
namespace flowslide {

/// Motion of a touching pair: velocities at the half step, geometry at the full step.
struct ContactKinematics {
  Vector3 normal = Vector3::UnitX();             ///< n, unit vector from the second centre to the first
  double overlap = 0.0;                          ///< delta = R_1 + R_2 - |x_1 - x_2|, m, >= 0
  Vector3 relative_velocity = Vector3::Zero();   ///< v_1 - v_2 of the centres, m/s
  Vector3 spin_first = Vector3::Zero();          ///< w_1, rad/s
  Vector3 spin_second = Vector3::Zero();         ///< w_2, rad/s
};

/// Force and torques of a contact on its two spheres, and its new history.
struct ContactForce {
  Vector3 on_first = Vector3::Zero();            ///< N; its negative acts on the second
  Vector3 torque_on_first = Vector3::Zero();     ///< N m, about the centre, rolling torque included
  Vector3 torque_on_second = Vector3::Zero();    ///< N m, likewise
  Vector3 tangential_spring = Vector3::Zero();   ///< m, of the first relative to the second
  Vector3 rolling_torque = Vector3::Zero();      ///< N m, of the spring alone; its negative acts on the first
  double normal = 0.0;                           ///< F_n, N, repulsion positive; the dashpot may make it negative
  bool sliding = false;                          ///< the tangential force is at the Coulomb cap
  bool rolling = false;                          ///< the rolling torque is at its cap
};

/// F_n = k_n delta - gamma_n v_n, N, with v_n the separation velocity (m/s) along n:
///   k_n = 4/3 Y* sqrt(R* delta), gamma_n = -2 sqrt(5/6) beta sqrt(S_n m*), S_n = 2 Y* sqrt(R* delta).
/// With y = delta^(5/4) this is a linear damped oscillator. An impact that ends at delta = 0 therefore returns exactly
/// the fraction e of its velocity, at any velocity (Antypov and Elliott 2011).
double normal_force(const PairConstants& pair, double overlap, double separation_velocity);

/// A stored spring counts as capped within this relative distance of its cap. The value is larger than the rounding of
/// the scaling to the cap (about 1e-16, or 1e-7 with the law in float), and smaller than any physical difference.
inline constexpr double cap_tolerance = 1e-6;

/// Force and torques of a contact from its history `tangential_spring` s (m) and `rolling_torque` M (N m).
///
/// With v_t = v - (v.n) n - (c_1 w_1 + c_2 w_2) x n, c_i = R_i - delta/2, and w = w_1 - w_2 minus its part along n:
///   normal      F_n = k_n delta - gamma_n v_n, not clipped at zero
///   tangential  s <- s + v_t dt, then s <- s - (s.n) n;   k_t = S_t = 8 G* sqrt(R* delta)
///               k_t |s| >  mu |F_n|:  s <- s mu |F_n| / (k_t |s|), F_t = -k_t s
///               else                  F_t = -k_t s - gamma_t v_t, gamma_t = -2 sqrt(5/6) beta sqrt(S_t m*)
///   rolling     M <- M + k_r w dt, k_r = rolling_stiffness k_n mu_r^2 R*^2
///               |M| >  mu_r |F_n| R*: M <- M mu_r |F_n| R* / |M|, torque M
///               else                  torque M + eta_r 2 sqrt(I_r k_r) w
///   on first    force F_n n + F_t, torque -c_1 n x F_t - (rolling torque)
///   on second   minus the force,   torque -c_2 n x F_t + (rolling torque)
/// `sliding` and `rolling` state whether the cap was reached. M is neither projected nor rotated with the contact.
///
/// advance_history = true makes one step of `time_step` (s). false evaluates the force of a history stored at the end
/// of a step: s and M are not changed, because both are capped already. `spring_cap` and `torque_cap` then state
/// whether the contact slides and rolls. If they are unknown, k_t |s| >= (1 - cap_tolerance) mu |F_n| counts as
/// sliding, and likewise for rolling; a spring beyond its cap then acts with the cap.
ContactForce evaluate_contact(const Material& material, const PairConstants& pair, const ContactKinematics& motion,
                              const Vector3& tangential_spring, const Vector3& rolling_torque, double time_step,
                              bool advance_history, Cap spring_cap = Cap::unknown, Cap torque_cap = Cap::unknown);

/// Force (N, repulsion positive, not clipped) of a frictionless plane of the same material on a sphere of `radius` (m)
/// and `mass` (kg): Hertz with dashpot, R* = R, m* = m. `approach_velocity` (m/s) is positive when the overlap (m)
/// grows.
double plane_normal_force(const Material& material, double radius, double mass, double overlap,
                          double approach_velocity);

}  // namespace flowslide
