// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "grains/assembly.hpp"
#include "grains/material.hpp"

namespace flowslide {

/// A time step (s) at which a head-on impact of two equal grains of `radius` (m) at the relative speed `speed`
/// (m/s) is stable at its largest overlap. `time_step` (s) is a first guess. Infinite at speed 0.
double time_step_for_impacts(double radius, const Material& material, double speed, double time_step);

/// A time step (s) that is stable with a reserve: half of a stable step of the present contacts (see
/// time_step_below_edge), and at most half of that for an impact of two of the smallest grains at twice the largest
/// velocity. Contacts may
/// become four times as stiff, and their forces 64 times as large with Hertz' law, before the step is unstable.
/// `time_step` (s) is the present step. Infinite without contacts and motion. Costs about 60 steps.
double stable_time_step(const Assembly& assembly, const Material& material, double time_step);

}  // namespace flowslide
