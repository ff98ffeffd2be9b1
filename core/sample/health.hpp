// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <cstdint>

#include "dem/engine.hpp"

namespace flowslide {

/// Largest time step as a share of the Rayleigh time of the smallest grain. At 0.64 (1e-5 s) the undrained peak at
/// 28 kPa is that of a step twenty times smaller to 0.04 % (cases/fig03_undrained/README.md). It knows neither the
/// stress nor how many contacts a grain has: see check_contact_time_step.
inline constexpr double largest_share_of_rayleigh_time = 0.65;
/// Overlap beyond which grains are no longer nearly rigid, as a share of the smaller diameter.
inline constexpr double largest_overlap = 0.05;

/// The longest time step (s) that is allowed: 0.65 Rayleigh times of a sphere of `smallest_radius` (m).
double longest_time_step(double smallest_radius, const Material& material);

/// Throws std::invalid_argument unless 0 < time_step <= 0.65 Rayleigh times of a sphere of `smallest_radius` (m).
void validate_time_step(double time_step, double smallest_radius, const Material& material);

/// Throws NumericalFailure if a grain is missing or a stress is not finite. Cheap: for every exchange.
void check_exchange(const Engine& engine, const CellStress& stress, std::uint64_t expected_grains);

/// Throws NumericalFailure if a position or velocity is not finite, or two grains overlap by more than 5 % of the
/// smaller diameter. Loops over all grains: for every recorded row.
void check_assembly(const Assembly& assembly);

/// Throws NumericalFailure if the time step (s) is too long for the contacts as stiff and as many as they are now (see
/// time_step_share): motions would grow, and dashpots and friction eat them, so that grains lose stress without a sign.
/// Contacts stiffen with the cube root of the stress: a step that suits a sample at rest may not suit it when it has
/// dilated. Costs some 60 steps: for every `time_step_interval` steps.
void check_contact_time_step(const Assembly& assembly, const Material& material, double time_step);

/// Local steps between two calls of check_contact_time_step: they cost 1.5 % of the run, and the stress of a
/// quasi-static sample changes by a few percent in between.
inline constexpr std::int64_t time_step_interval = 4000;

/// Mean kinetic energy of translation of a mobile grain over pressure (Pa) times the cube of the mean diameter.
double kinetic_number(const Assembly& assembly, const Material& material, double pressure);

}  // namespace flowslide
