// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

namespace flowslide {

/// An infinite slope with a liquefiable layer at its base. The defaults are those of Table 2 of the paper at a slope
/// angle of 5 deg (Fig. 8). The water table is at the top of the liquefiable layer (h_w = h_s).
struct SlopeProperties {
  double saturated_density = 2000.0;               ///< rho_sat, kg/m^3, below the water table
  double dry_density = 1500.0;                     ///< rho_d, kg/m^3, above the water table
  double thickness = 2.0;                          ///< h, m
  double liquefiable_thickness = 0.2;              ///< h_s, m
  double water_table = 0.2;                        ///< h_w, m above the base
  double angle = 0.087266462599716474;             ///< theta, rad (5 deg)
  double gravity = 9.81;                           ///< g, m/s^2
  double water_density = 1000.0;                   ///< rho_w, kg/m^3
  double hydraulic_conductivity = 0.0;             ///< k, m/s; 0 is undrained

  /// gamma_w = rho_w g, N/m^3.
  double unit_weight_of_water() const { return water_density * gravity; }
};

/// Throws std::invalid_argument if a property is not finite or out of its range: densities, gravity and thicknesses
/// > 0, rho_sat > rho_w, rho_sat >= rho_d, 0 < h_s <= h, 0 <= h_w <= h, 0 <= theta < pi/2, k >= 0. theta = 0 is level
/// ground.
void validate(const SlopeProperties& slope);

/// m = rho_sat h_w + rho_d (h - h_w), kg per m^2 of base (eq. 7). Throws as `validate`.
double mass_per_area(const SlopeProperties& slope);

/// tau_0 = [rho_sat h_w + rho_d (h - h_w)] g sin(theta), Pa, positive downslope (eq. 8). Throws as `validate`.
double initial_shear_stress(const SlopeProperties& slope);

/// sigma_0 = [(rho_sat - rho_w) h_w + rho_d (h - h_w)] g cos(theta), Pa, effective, compression positive (eq. 9).
/// Throws as `validate`.
double initial_normal_stress(const SlopeProperties& slope);

}  // namespace flowslide
