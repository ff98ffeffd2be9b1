// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <cstdint>

#include "dem/engine.hpp"

namespace flowslide {

/// Largest time step as a fraction of the Rayleigh time of the smallest grain. At 0.64 (1e-5 s) the undrained peak at
/// 28 kPa differs by 0.04 % from the peak with a step twenty times smaller (cases/fig03_undrained/README.md). This
/// limit depends neither on the stress nor on the number of contacts of a grain: see check_contact_time_step.
inline constexpr double largest_share_of_rayleigh_time = 0.65;
/// Largest overlap of nearly rigid grains, as a fraction of the smaller diameter.
inline constexpr double largest_overlap = 0.05;

/// The longest allowed time step, s: 0.65 Rayleigh times of a sphere of `smallest_radius` (m).
double longest_time_step(double smallest_radius, const Material& material);

/// Throws std::invalid_argument unless 0 < time_step <= 0.65 Rayleigh times of a sphere of `smallest_radius` (m).
void validate_time_step(double time_step, double smallest_radius, const Material& material);

/// Throws NumericalFailure if a grain is missing or a stress is not finite. Cheap: called at every exchange.
void check_exchange(const Engine& engine, const CellStress& stress, std::uint64_t expected_grains);

/// Throws NumericalFailure if a position or velocity is not finite, or two grains overlap by more than 5 % of the
/// smaller diameter. Loops over all grains and contacts: called for every recorded row.
void check_assembly(const Assembly& assembly);

/// Throws NumericalFailure if the time step (s) is too long for the present stiffness and number of the contacts (see
/// time_step_share). Oscillations would then grow, dashpots and friction would dissipate them, and the sample would
/// lose stress without any visible sign. The stiffness of contacts grows with the cube root of the stress. A step that
/// suits a sample at rest may therefore be too long after dilation. Costs about 60 steps: called every
/// `time_step_interval` steps.
void check_contact_time_step(const Assembly& assembly, const Material& material, double time_step);

/// Local steps between two calls of check_contact_time_step. The calls then cost 1.5 % of a run, and the stress of a
/// quasi-static sample changes by a few percent between two calls.
inline constexpr std::int64_t time_step_interval = 4000;

/// Mean translational kinetic energy of the mobile grains over p D^3, dimensionless: p is `pressure` (Pa), D the mean
/// diameter. 0 without mobile grains.
double kinetic_number(const Assembly& assembly, const Material& material, double pressure);

}  // namespace flowslide
