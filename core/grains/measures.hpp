// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "grains/assembly.hpp"
#include "grains/material.hpp"

namespace flowslide {

/// e = (V - V_s) / V_s of the whole cell. V_s is the volume of all spheres: glued spheres count, and overlaps are not
/// subtracted. Throws std::invalid_argument without grains.
double void_ratio(const Assembly& assembly);

/// Void ratio between two horizontal planes, `margin` (m) inside the bottom and the top of the cell. Of a sphere that a
/// plane cuts, the part between the planes counts. Throws std::invalid_argument unless 0 <= margin < height / 2, or if
/// no solid is between the planes.
double void_ratio_of_bulk(const Assembly& assembly, double margin);

/// Void ratio of a probe without the outer 7.5 % of the height at the bottom and at the top, as the public input decks
/// of the paper's first author take it. Away from the planes a packing is denser.
double probe_void_ratio(const Assembly& assembly);

/// Volume (m^3) of the part of a sphere below a horizontal plane that is `height` (m) above its centre; `height` is
/// negative for a plane below the centre.
double volume_below(double radius, double height);

/// I = gamma_dot D sqrt(rho / p) (paper, sec. 2.2.1), with the sign of the shear rate. shear_rate in 1/s, mean_diameter
/// in m, density of the solid in kg/m^3, pressure in Pa. Throws std::invalid_argument unless the last three are > 0.
double inertial_number(double shear_rate, double mean_diameter, double density, double pressure);

/// The shear rate (1/s) at which the inertial number has the given value. Throws as `inertial_number`.
double shear_rate_for(double inertial_number, double mean_diameter, double density, double pressure);

/// Rayleigh time of a sphere, s: t_R = pi R sqrt(rho / G) / (0.1631 nu + 0.8766), the time in which a Rayleigh wave
/// travels half of the circumference, as in LIGGGHTS (fix check/timestep/gran). For the limit of the time step see
/// sample/health.hpp.
double rayleigh_time(double radius, const Material& material);

/// Largest overlap (m) of the undamped head-on impact of two equal spheres at the relative speed `impact_speed` (m/s):
/// [15 m* v^2 / (16 Y* sqrt(R*))]^(2/5). Source: Hertz; Johnson, Contact Mechanics, ch. 11. Throws
/// std::invalid_argument unless impact_speed > 0.
double hertz_impact_overlap(double radius, const Material& material, double impact_speed);

}  // namespace flowslide
