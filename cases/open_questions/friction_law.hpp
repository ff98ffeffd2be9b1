// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <vector>

namespace flowslide {

/// Friction of dense granular flow over the inertial number,
///   mu(I) = mu_s + (mu_2 - mu_s)/(1 + I_0/I),
/// as printed by P. Jop, Y. Forterre and O. Pouliquen, Nature 441 (2006) 727-730, after GDR MiDi, Eur. Phys. J. E 14
/// (2004) 341-365. Range: steady shear between the quasi-static and the collisional regime, about 1e-3 < I < 0.5.
struct FrictionLaw {
  double slow = 0.0;       ///< mu_s, for I -> 0
  double fast = 0.0;       ///< mu_2, for I -> infinity
  double turning = 0.0;    ///< I_0, > 0

  double at(double inertial_number) const { return slow + (fast - slow) / (1.0 + turning / inertial_number); }
};

/// The law for glass beads, with the friction angles and I_0 of Jop, Forterre and Pouliquen (2006).
FrictionLaw law_of_glass_beads();

/// One steady state: I and mu = tau/sigma.
struct SteadyState {
  double inertial_number = 0.0, friction = 0.0;
};

/// Whether the states determine a law: at least four states with I > 0, not all at the same I.
bool tell_a_law(const std::vector<SteadyState>& states);

/// The law that fits the states best, by least squares of mu. For a given I_0 the law is linear in mu_s and mu_2. I_0
/// is found by a search between the smallest and the largest I of the states. Throws std::invalid_argument unless
/// tell_a_law.
FrictionLaw fit_friction_law(const std::vector<SteadyState>& states);

/// RMS difference of the states from a law.
double deviation(const std::vector<SteadyState>& states, const FrictionLaw& law);

}  // namespace flowslide
