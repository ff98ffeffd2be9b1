// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "program/slide_case.hpp"

namespace flowslide {

/// Strain of a test up to which it is a probe of the small-strain modulus.
inline constexpr double probe_strain = 1e-3;
/// Strain from which a test or a held slope counts as steady: the paper's, sec. 3.1, and where the faces of a cell have
/// slid over each other once.
inline constexpr double steady_strain = 0.5, steady_flow_strain = 1.0;

/// The numbers of a slide that is held at its driving stress; `final_velocity` is that of its last row:
///   steady_friction    mu_ss, mean tau over mean sigma beyond 50 % strain
///   final_velocity     m/s
///   linearity_<i>      R^2 of a straight line through the i-th profile of v_x
std::vector<Metric> held_metrics(const RunMeasures& measures, const Series& profiles, double final_velocity);

/// The numbers of steady shear at constant volume, means over strain beyond 1, kinetic parts included:
///   shear_rate, steady_shear, steady_normal, steady_mean   1/s and Pa
///   inertial_number    gamma_dot D sqrt(rho / p), of the mean p: I itself has no mean where p nears nothing
///   friction           mu, tau over sigma
/// NaN where the record does not reach a strain of 1. `grains` are those of the sample.
std::vector<Metric> flow_metrics(const Series& series, double shear_rate, double mean_diameter, double density);

/// What a sample is, for its natural frequency.
struct Body {
  double height = 0.0;    ///< H, m
  double density = 0.0;   ///< of solid and voids together, kg/m^3
  bool periodic = false;  ///< along z; else held at the bottom and the top
};

/// The numbers of the first strain of a sample:
///   shear_modulus      G, Pa, of the straight line that fits tau over gamma best
///   shear_wave_speed   c = sqrt(G/rho_b), m/s
///   sample_frequency   f of the sample's first shear mode, Hz: c/(2 H) between layers that are held, c/H in a cell that
///                      is periodic along z, where the longest wave is as long as the cell
///   slope_frequency    f of the slope on the sample, Hz: sqrt(G/(h_s m))/(2 pi), as eqs 1 and 3 with tau = G gamma say
///   frequency_ratio    of the former over the latter, in which G cancels
/// A sample whose stress still creeps may have a G below 0 in so small a strain: speeds and frequencies are then NaN.
std::vector<Metric> probe_metrics(const Series& series, const Body& sample, const SlopeProperties& slope);

}  // namespace flowslide
