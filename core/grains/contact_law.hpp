// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "grains/laws/contact.hpp"
#include "grains/material.hpp"
#include "grains/pair_constants.hpp"

/// The contact law in plain form, composed of the parts in grains/laws: the law of LIGGGHTS 3.8 (`tangential_damping
/// on`) that `material.contact_law` names. The native engine steps the grains with the lane form of
/// the same parts, beside the plain form in the same headers.
namespace flowslide {

/// Force and torques of a contact on its two spheres, and its new history.
struct ContactForce {
  Vector3 on_first = Vector3::Zero();            ///< N; its negative acts on the second
  Vector3 torque_on_first = Vector3::Zero();     ///< N m, about the centre, rolling torque included
  Vector3 torque_on_second = Vector3::Zero();    ///< N m, likewise
  Vector3 tangential_spring = Vector3::Zero();   ///< m, of the first relative to the second
  Vector3 rolling_torque = Vector3::Zero();      ///< N m, of the spring alone; its negative acts on the first
  double normal = 0.0;                           ///< F_n, N, repulsion positive; below 0 only without limit
  bool sliding = false;                          ///< the tangential force is at the Coulomb cap
  bool rolling = false;                          ///< the rolling torque is at its cap
};

/// Springs and dashpots of the law at this overlap (m).
laws::ContactStiffness contact_stiffness(const Material& material, const PairConstants& pair, double overlap);

/// F_n = k_n delta - gamma_n v_n, N, with v_n the separation velocity (m/s) along n, and at least 0 if the material has
/// `normal_force_limited`.
double normal_force(const Material& material, const PairConstants& pair, double overlap, double separation_velocity);

/// Histories of a contact: s (m) of the tangential part and M (N m) of the rolling part.
struct ContactHistories {
  PartHistory tangential_spring, rolling_torque;
};

/// Force and torques of one step of `time_step` (s) from these histories, which it advances. The caps of the histories
/// are not read.
///   on first    force F_n n + F_t, torque -c_1 n x F_t - (rolling torque)
///   on second   minus the force,   torque -c_2 n x F_t + (rolling torque)
/// with the lever arms c_i = R_i - delta/2. `sliding` and `rolling` state whether the cap was reached.
ContactForce step_contact(const Material& material, const PairConstants& pair, const ContactKinematics& motion,
                          const ContactHistories& histories, double time_step);

/// Force and torques of histories that were stored at the end of a step. s and M are not changed, because both are
/// capped already. The caps of the histories state whether the contact slides and rolls. If they are unknown,
/// k_t |s| >= (1 - cap_tolerance) mu |F_n| counts as sliding, and likewise for rolling; a spring beyond its cap then
/// acts with the cap.
ContactForce stored_contact(const Material& material, const PairConstants& pair, const ContactKinematics& motion,
                            const ContactHistories& histories);

/// Force (N, repulsion positive) of a frictionless plane of the same material on a sphere of `radius` (m)
/// and `mass` (kg): the normal part with R* = R and m* = m. `approach_velocity` (m/s) is positive when the overlap (m)
/// grows.
double plane_normal_force(const Material& material, double radius, double mass, double overlap,
                          double approach_velocity);

}  // namespace flowslide
