// SPDX-License-Identifier: GPL-2.0-or-later
// Rules for the strain rate of the sample: the upper bound eps_L^U of eqs 15 to 18.
#pragma once
#include <variant>

namespace flowslide {

/// Properties of the grains in an inertial number.
struct GrainScale {
  double mean_diameter = 6e-3;  ///< D, m
  double density = 2650.0;      ///< of the solid, kg/m^3
};

/// RD: the strain rate of the slope, ||d(epsilon_G)||/dt_G (paper, sec. 2.3).
struct GlobalRate {};

/// A constant rate, as in an element test of the sample alone. In Figs 6 and 7 it is the rate of an inertial number at
/// the initial stress.
struct ConstantStrainRate {
  double rate = 0.06;            ///< 1/s, > 0
  double inertial_number = 0.0;  ///< I of this rate at the initial stress; 0: the rate itself was chosen
};

/// RI: the rate of a constant inertial number at the current pressure, I sqrt(p/rho)/D. The rate vanishes with p, so a
/// floor bounds the cost; the rate asked for includes the floor. A constant floor would raise the stress peak. The
/// floor therefore ramps up as gamma^2 and reaches `smallest_rate` at `smallest_rate_from`.
struct ConstantInertialNumber {
  double inertial_number = 1e-4;  ///< I, > 0
  double smallest_rate = 0.5;     ///< the floor, 1/s, >= 0
  GrainScale grains;
  double smallest_rate_from = 0.0;  ///< |gamma| of the slope at the end of the ramp, >= 0
};

/// Hybrid of RD and RI: the rate of the slope or the rate of a quasi-static inertial number, whichever is higher. It
/// saves local steps where the rate does not matter. A liquefied sample (p = 0) is sheared at the rate of the slope.
struct GlobalRateAtLeastQuasiStatic {
  double inertial_number = 1e-4;  ///< I, > 0
  GrainScale grains;
};

using RateRule = std::variant<GlobalRate, ConstantStrainRate, ConstantInertialNumber, GlobalRateAtLeastQuasiStatic>;

/// Throws std::invalid_argument if a value is out of its range.
void validate(const RateRule& rule);

/// The same rule for other grains. A rule that is given by an inertial number keeps it, and its rates change. A rate
/// that was chosen itself stays. `initial_normal_stress` is sigma_0 of the slope, Pa.
RateRule for_grains(const RateRule& rule, const GrainScale& grains, double initial_normal_stress);

/// The rate asked for, 1/s, >= 0. `global_rate` (1/s, >= 0) and `shear_strain` are those of the slope. `pressure` (Pa)
/// is that of the sample; a negative value counts as 0.
double rate_asked(const RateRule& rule, double global_rate, double pressure, double shear_strain);

}  // namespace flowslide
