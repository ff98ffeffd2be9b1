// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "grains/assembly.hpp"
#include "grains/material.hpp"

namespace flowslide {

/// A time step (s) at which a head-on impact of two equal grains of `radius` (m) at the relative speed `speed`
/// (m/s) is stable at its largest overlap. `time_step` (s) is a first guess. Infinite at speed 0.
double time_step_for_impacts(double radius, const Material& material, double speed, double time_step);

/// A time step (s) that is stable with a reserve: 0.8 of a stable step of the present contacts (see
/// time_step_below_edge), and at most 0.8 of that for an impact of two of the smallest grains at twice the largest
/// velocity. All contacts may become 1.5 times as stiff, and their forces 3.8 times as large with Hertz' law, before
/// the step is unstable. `time_step` (s) is the present step. Infinite without contacts and motion. Costs about 60
/// steps.
///
/// The stiffest contacts of a liquefied sample are those of grains wedged between glued ones: they keep an overlap of
/// the initial stress while the others open. They bound the step, however soft the other contacts are.
double stable_time_step(const Assembly& assembly, const Material& material, double time_step);

}  // namespace flowslide
