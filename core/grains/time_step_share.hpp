// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "grains/assembly.hpp"
#include "grains/material.hpp"

namespace flowslide {

/// How near a time step (s) is to the longest at which the contacts of an assembly, as they stand, swing without
/// growing: 1 at the edge, more beyond it.
///
/// The engines' scheme moves by central differences and shows the dashpots the velocities of the half step, so that a
/// network of contacts with stiffness K, damping C and masses M (moments of inertia for spins) goes on by
///   M (x_(n+1) - 2 x_n + x_(n-1)) = -dt^2 K x_n - dt C (x_n - x_(n-1)).
/// Its first motion to grow changes sign at every step, x_n = (-1)^n phi, and does so when
///   lambda_max{M^-1 (dt^2 K + 2 dt C)}/4 = 1,
/// which is what is returned. For a single undamped spring that is the known dt = 2/omega. Each contact adds to K its
/// S_n = 2 Y* sqrt(R* delta) along the normal, k_t = 8 G* sqrt(R* delta) between the surfaces, spins included, and k_r
/// of the rolling spring, and to C their dashpots (see contact_law.hpp); planes add theirs. All contacts count as
/// sticking, which is on the safe side. lambda_max is found by Lanczos from below, to some 1 % in `iterations`. Cost:
/// that of a contact search and about two steps per iteration. 0 without contacts.
double time_step_share(const Assembly& assembly, const Material& material, double time_step, int iterations = 14);

/// About the longest time step (s) of which time_step_share is 1, from the share of one: between the limits without
/// damping, dt/sqrt(share), and of damping alone, dt/share.
double time_step_at_edge(double time_step, double share);

}  // namespace flowslide
