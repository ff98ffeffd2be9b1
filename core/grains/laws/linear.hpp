// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <tuple>

#include "grains/fields.hpp"
#include "grains/laws/contact.hpp"
#include "grains/laws/lane.hpp"
#include "grains/laws/normal_force_limit.hpp"

namespace flowslide::laws {

/// Parameter of the part Linear.
struct LinearParameters {
  double characteristic_velocity = 1.0;  ///< v_c, m/s

  bool operator==(const LinearParameters&) const = default;
  static constexpr auto fields() {
    return std::tuple{Field{"characteristic_velocity", &LinearParameters::characteristic_velocity, "m/s",
                            Bounds::positive()}};
  }
};
static_assert(lists_every_member<LinearParameters>());

/// Normal part of the law "linear": a linear spring with a dashpot, and the same along the contact plane (P. A. Cundall
/// and O. D. L. Strack, Geotechnique 29 (1979) 47-65). The stiffness is that of `hooke` of LIGGGHTS 3.8 (`ktToKnUser
/// off`): two grains that meet at the characteristic velocity v_c overlap as much as those of Hertz.
///   F_n = k_n delta - gamma_n v_n; below 0 see NormalForceLimit
///   k_n = 16/15 sqrt(R*) Y* (15 m* v_c^2 / (16 sqrt(R*) Y*))^(1/5),  gamma_n = -2 beta sqrt(k_n m*)
///   k_t = k_n,                                                       gamma_t = gamma_n
/// An impact that ends at delta = 0 returns exactly the fraction e of its velocity, and lasts
/// pi sqrt(m* / (k_n (1 - beta^2))), both at any velocity.
struct Linear {
  static constexpr const char* liggghts_model = "hooke";

  using Parameters = List<NormalForceLimit, LinearParameters>;
  static constexpr std::tuple liggghts_properties{LiggghtsProperty{
      "characteristicVelocity", PropertyKind::scalar, &LinearParameters::characteristic_velocity}};
  static constexpr std::tuple liggghts_switches{limit_force};

  static ContactStiffness stiffness(const auto& p, const PairConstants& pair, double) {
    const double root = root_scale(pair.effective_radius, pair.effective_mass);
    const double normal = coefficient(p, pair) * root * root;
    const double damping = -2.0 * pair.damping * std::sqrt(normal * pair.effective_mass);
    return {.normal = normal,
            .loading = normal,
            .tangential = normal,
            .normal_damping = damping,
            .tangential_damping = damping};
  }

  template <typename Real>
  struct Constants : StiffnessConstants<Real> {};

  template <typename Real>
  static Constants<Real> constants(const auto& p, const PairConstants& pair) {
    const double normal = coefficient(p, pair);
    const auto stiffness = static_cast<Real>(normal);
    const auto damping = static_cast<Real>(-2.0 * pair.damping * std::sqrt(normal));
    return {{.normal = stiffness,
             .normal_damping = damping,
             .tangential = stiffness,
             .tangential_damping = damping,
             .lowest_force = lowest_force<Real>(p)}};
  }

  /// The scale of a pair is s = (R*^2 m*)^(1/5), so that k_n = coefficient s.
  static constexpr bool scale_is_constant = true;
  static double root_scale(double effective_radius, double effective_mass) {
    return std::pow(effective_radius * effective_radius * effective_mass, 0.1);
  }

  template <typename Real>
  FLOWSLIDE_LANE static Real force(const Constants<Real>& c, const Lane<Real>& contact) {
    return spring_and_dashpot(c, contact);
  }

 private:
  static double coefficient(const LinearParameters& p, const PairConstants& pair) {
    const double squared = p.characteristic_velocity * p.characteristic_velocity;
    return 16.0 / 15.0 * pair.effective_modulus * std::pow(15.0 * squared / (16.0 * pair.effective_modulus), 0.2);
  }
};

}  // namespace flowslide::laws
