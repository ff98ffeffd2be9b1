// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "grains/assembly.hpp"
#include "grains/material.hpp"

namespace flowslide {

/// e = (V - V_s) / V_s of the whole cell; V_s is the volume of all spheres, glued ones included and overlaps not
/// deducted. Throws std::invalid_argument if there is no grain.
double void_ratio(const Assembly& assembly);

/// Void ratio between the horizontal planes `margin` (m) inside the bottom and the top of the cell. A sphere cut by
/// one of the two counts with the part between them. Throws std::invalid_argument unless 0 <= margin < height / 2, or
/// if no solid lies between the planes.
double void_ratio_of_bulk(const Assembly& assembly, double margin);

/// Volume (m^3) of the part of a sphere that lies at or below a plane `height` (m) above its centre (below: negative).
double volume_below(double radius, double height);

/// I = gamma_dot D sqrt(rho / p) (paper, sec. 2.2.1). shear_rate 1/s (its sign is kept), mean_diameter m,
/// density of the solid kg/m^3, pressure Pa. Throws std::invalid_argument unless the last three are > 0.
double inertial_number(double shear_rate, double mean_diameter, double density, double pressure);

/// The shear rate (1/s) at which the inertial number has the given value. Errors as for `inertial_number`.
double shear_rate_for(double inertial_number, double mean_diameter, double density, double pressure);

/// Time (s) in which a Rayleigh wave crosses half of a sphere, t_R = pi R sqrt(rho / G) / (0.1631 nu + 0.8766), as
/// LIGGGHTS takes it (fix check/timestep/gran). Explicit steps are kept below a few percent of it.
double rayleigh_time(double radius, const Material& material);

/// Largest overlap (m) of the undamped head-on impact of two equal spheres at the relative speed `impact_speed` (m/s):
/// [15 m* v^2 / (16 Y* sqrt(R*))]^(2/5). Source: Hertz; Johnson, Contact Mechanics, ch. 11. Throws
/// std::invalid_argument unless impact_speed > 0.
double hertz_impact_overlap(double radius, const Material& material, double impact_speed);

}  // namespace flowslide
