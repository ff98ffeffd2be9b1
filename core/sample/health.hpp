// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <cstdint>

#include "dem/engine.hpp"

namespace flowslide {

/// Largest time step as a share of the Rayleigh time of the smallest grain. At 0.64 (1e-5 s) the undrained peak is that
/// of a step twenty times smaller to 0.04 % (cases/fig03_undrained/README.md); near 1 it goes wrong without a sign.
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

/// Mean kinetic energy of translation of a mobile grain over pressure (Pa) times the cube of the mean diameter.
double kinetic_number(const Assembly& assembly, const Material& material, double pressure);

}  // namespace flowslide
