// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <tuple>

#include "grains/laws/contact.hpp"
#include "grains/laws/lane.hpp"
#include "grains/laws/normal_force_limit.hpp"

namespace flowslide::laws {

/// Normal part of the law "hertz": Hertz' contact of two elastic spheres with a dashpot, and Mindlin's tangential
/// stiffness without slip (R. D. Mindlin, J. Appl. Mech. 16 (1949) 259-268). The dashpots are those of Y. Tsuji, T.
/// Tanaka and T. Ishida, Powder Technol. 71 (1992) 239-250.
///   F_n = k_n delta - gamma_n v_n; below 0 see NormalForceLimit
///   k_n = 4/3 Y* sqrt(R* delta),  S_n = 2 Y* sqrt(R* delta),  gamma_n = -2 sqrt(5/6) beta sqrt(S_n m*)
///   k_t = 8 G* sqrt(R* delta),                               gamma_t = -2 sqrt(5/6) beta sqrt(k_t m*)
/// With y = delta^(5/4) the normal part is a linear damped oscillator. An impact that ends at delta = 0 therefore
/// returns exactly the fraction e of its velocity, at any velocity (T. Antypov and J. A. Elliott, EPL 94 (2011) 50004).
struct Hertz {
  static constexpr const char* liggghts_model = "hertz";

  using Parameters = List<NormalForceLimit>;  ///< E, nu and e are properties of the grains
  static constexpr std::tuple<> liggghts_properties{};
  static constexpr std::tuple liggghts_switches{limit_force};

  static ContactStiffness stiffness(const auto&, const PairConstants& pair, double overlap) {
    const double scale = std::sqrt(pair.effective_radius * overlap);
    const auto dashpot = [&](double stiffness) {
      return dashpot_coefficient(pair) * std::sqrt(stiffness * pair.effective_mass);
    };
    const double normal = 4.0 / 3.0 * pair.effective_modulus * scale;
    const double tangential = 8.0 * pair.effective_shear_modulus * scale;
    return {.normal = normal,
            .loading = 2.0 * pair.effective_modulus * scale,
            .tangential = tangential,
            .normal_damping = dashpot(1.5 * normal),  // S_n = 3/2 k_n
            .tangential_damping = dashpot(tangential)};
  }

  template <typename Real>
  struct Constants : StiffnessConstants<Real> {};

  /// `pair` is any pair of the material: moduli and damping do not depend on the radii. s = sqrt(R* delta), m.
  template <typename Real>
  static Constants<Real> constants(const auto& p, const PairConstants& pair) {
    const double tangential = 8.0 * pair.effective_shear_modulus, dashpot = dashpot_coefficient(pair);
    return {{.normal = static_cast<Real>(4.0 / 3.0 * pair.effective_modulus),
             .normal_damping = static_cast<Real>(dashpot * std::sqrt(2.0 * pair.effective_modulus)),
             .tangential = static_cast<Real>(tangential),
             .tangential_damping = static_cast<Real>(dashpot * std::sqrt(tangential)),
             .lowest_force = lowest_force<Real>(p)}};
  }

  /// The scale changes with the overlap.
  static constexpr bool scale_is_constant = false;
  template <typename Real>
  FLOWSLIDE_LANE static void scales(Real effective_radius, Real overlap, Real& scale, Real& root_scale) {
    two_roots(effective_radius * overlap, scale, root_scale);
  }

  template <typename Real>
  FLOWSLIDE_LANE static Real force(const Constants<Real>& c, const Lane<Real>& contact) {
    return spring_and_dashpot(c, contact);
  }
};

}  // namespace flowslide::laws
