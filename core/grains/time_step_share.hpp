// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "grains/assembly.hpp"
#include "grains/material.hpp"

namespace flowslide {

/// How close a time step (s) is to the stability limit of the present contacts: 1 at the limit, more if oscillations
/// grow.
///
/// The engines use central differences, and their dashpots use the velocities of the half step. A network of contacts
/// with stiffness K, damping C and masses M (moments of inertia for spins) therefore moves by
///   M (x_(n+1) - 2 x_n + x_(n-1)) = -dt^2 K x_n - dt C (x_n - x_(n-1)).
/// The first motion that grows changes sign at every step, x_n = (-1)^n phi. It starts to grow when
///   lambda_max{M^-1 (dt^2 K + 2 dt C)}/4 = 1.
/// The function returns this left side. For a single undamped spring the criterion is the known dt = 2/omega.
///
/// Each contact adds to K: S_n = 2 Y* sqrt(R* delta) along the normal, k_t = 8 G* sqrt(R* delta) between the surfaces,
/// spins included, and k_r of the rolling spring. It adds to C the dashpots of these springs (see contact_law.hpp).
/// Contacts with planes do the same along their normal. All contacts count as sticking, which is conservative. Lanczos
/// iteration finds lambda_max from below, to about 1 % in `iterations`. Cost: a contact search and about two steps per
/// iteration. Returns 0 without contacts.
double time_step_share(const Assembly& assembly, const Material& material, double time_step, int iterations = 14);

/// A time step (s) that is stable: the lower one of the two limits of time_step_at_edge. With `share` below 1 it is
/// dt/sqrt(share). Infinite at a share of 0.
double time_step_below_edge(double time_step, double share);

/// Estimate of the longest stable time step (s), from `time_step` (s) and its time_step_share: dt/share^0.6. It is
/// between the limits without damping, dt/sqrt(share), and with damping alone, dt/share.
double time_step_at_edge(double time_step, double share);

}  // namespace flowslide
