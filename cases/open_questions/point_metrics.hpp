// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "program/slide_case.hpp"

namespace flowslide {

/// A test that ends at or below this strain is a probe of the small-strain modulus.
inline constexpr double probe_strain = 1e-3;
/// Strain from which the state counts as steady. For a held slope it is that of the paper (sec. 3.1). For a test at
/// constant volume it is 1: the upper face of the cell has moved by one height.
inline constexpr double steady_strain = 0.5, steady_flow_strain = 1.0;

/// Metrics of a slide whose driving stress is held. `final_velocity` (m/s) is that of its last row.
///   steady_friction    mu_ss, mean tau over mean sigma beyond 50 % strain
///   final_velocity     m/s
///   linearity_<i>      R^2 of a straight line through the i-th profile of v_x
std::vector<Metric> held_metrics(const RunMeasures& measures, const Series& profiles, double final_velocity);

/// Metrics of steady shear at constant volume. Stresses are means over strain beyond 1 and include the kinetic parts.
///   shear_rate, steady_shear, steady_normal, steady_mean   1/s and Pa
///   inertial_number    gamma_dot D sqrt(rho/p) with the mean p; the mean of I does not exist where p vanishes
///   friction           mu, mean tau / mean sigma
/// NaN if the record does not extend beyond a strain of 1. Arguments: shear rate (1/s), mean diameter of the grains
/// (m), density of the solid (kg/m^3).
std::vector<Metric> flow_metrics(const Series& series, double shear_rate, double mean_diameter, double density);

/// Properties of a sample that decide its natural frequency.
struct Body {
  double height = 0.0;    ///< H, m
  double density = 0.0;   ///< rho_b, bulk density: solid mass / volume of the cell, kg/m^3
  bool periodic = false;  ///< true: periodic along z; false: held at the bottom and the top
};

/// Metrics of the small-strain stiffness of a sample:
///   shear_modulus      G, Pa: slope of the least-squares line of tau over gamma
///   shear_wave_speed   c = sqrt(G/rho_b), m/s
///   sample_frequency   first shear mode of the sample, Hz: c/(2 H) between held layers; c/H in a cell that is periodic
///                      along z, where the longest wave has the length of the cell
///   slope_frequency    oscillation of the slope on the sample, Hz: sqrt(G/(h_s m))/(2 pi), by eqs 1 and 3 with
///                      tau = G gamma
///   frequency_ratio    sample_frequency / slope_frequency; G cancels
/// If the stress of a sample still creeps, G may be negative at such small strains. Speed and frequencies are then NaN.
std::vector<Metric> probe_metrics(const Series& series, const Body& sample, const SlopeProperties& slope);

}  // namespace flowslide
