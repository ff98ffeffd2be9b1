// SPDX-License-Identifier: GPL-2.0-or-later
// Which strain rate a sample is to be sheared at: the upper bound eps_L^U of eqs 15 to 18.
#pragma once
#include <variant>

namespace flowslide {

/// What an inertial number needs besides rate and pressure.
struct GrainScale {
  double mean_diameter = 6e-3;  ///< D, m
  double density = 2650.0;      ///< of the solid, kg/m^3
};

/// RD: the rate of the slope, ||d(epsilon_G)||/dt_G (paper, sec. 2.3).
struct GlobalRate {};

/// The same rate all the time, as in an element test of the sample alone: in Figs 6 and 7 that of an inertial number at
/// the initial stress.
struct ConstantStrainRate {
  double rate = 0.06;            ///< 1/s, > 0
  double inertial_number = 0.0;  ///< I that it is at the initial stress; 0: the rate was chosen as such
};

/// RI: the rate of a constant inertial number at the current pressure, I sqrt(p/rho)/D. It tends to 0 with p, which
/// would take for ever: it is never below a floor, and what was used is the rate asked for. As a floor would raise the
/// peak, it grows with the square of the slope's shear strain up to `smallest_rate`.
struct ConstantInertialNumber {
  double inertial_number = 1e-4;  ///< I, > 0
  double smallest_rate = 0.5;     ///< 1/s, >= 0
  GrainScale grains;
  double smallest_rate_from = 0.0;  ///< shear strain, either way, from which the floor is that, >= 0
};

/// RD made quick where the rate does not matter: the rate of the slope, or the rate that keeps I at a value taken for
/// quasi-static where that is faster. A liquefied sample (p = 0) is sheared at the rate of the slope.
struct GlobalRateAtLeastQuasiStatic {
  double inertial_number = 1e-4;  ///< I, > 0
  GrainScale grains;
};

using RateRule = std::variant<GlobalRate, ConstantStrainRate, ConstantInertialNumber, GlobalRateAtLeastQuasiStatic>;

/// Throws std::invalid_argument if a value is out of its range.
void validate(const RateRule& rule);

/// The same rule for other grains: an inertial number stays, and the rates that follow from it change. A rate that was
/// chosen as such stays. `initial_normal_stress` is that of the slope, Pa.
RateRule for_grains(const RateRule& rule, const GrainScale& grains, double initial_normal_stress);

/// The rate asked for, 1/s, >= 0, when the slope strains at `global_rate` (1/s, >= 0), has sheared by `shear_strain` and
/// the sample bears `pressure` (Pa; less than nothing counts as nothing).
double rate_asked(const RateRule& rule, double global_rate, double pressure, double shear_strain);

}  // namespace flowslide
