// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "grains/fields.hpp"

namespace flowslide {

/// Properties of the grains and of their contacts. Defaults are those of Table 1 of the paper. The table does not give
/// the rolling stiffness and the rolling viscous damping; they follow the public input decks of the first author.
struct Material {
  double density = 2650.0;                 ///< rho, kg/m^3, of the solid
  double youngs_modulus = 2.0e9;           ///< E, Pa
  double poisson_ratio = 0.25;             ///< nu
  double restitution = 0.8;                ///< coefficient of restitution, in (0, 1]
  double sliding_friction = 0.5;           ///< mu
  double rolling_friction = 0.1;           ///< mu_r
  double rolling_stiffness = 2.25;         ///< factor of k_r = factor k_n mu_r^2 R*^2 (EPSD3), >= 1
  double rolling_viscous_damping = 0.13;   ///< eta_r of EPSD3, fraction of critical damping

  bool operator==(const Material&) const = default;
  /// G = E / (2 (1 + nu)), Pa.
  double shear_modulus() const { return youngs_modulus / (2.0 * (1.0 + poisson_ratio)); }

  static constexpr auto fields() {
    return std::tuple{
        Field{"density", &Material::density, "kg/m^3", Bounds::positive()},
        Field{"youngs_modulus", &Material::youngs_modulus, "Pa", Bounds::positive()},
        Field{"poisson_ratio", &Material::poisson_ratio, "1", Bounds::from_below(0.0, 0.5)},
        Field{"restitution", &Material::restitution, "1", Bounds::above_up_to(0.0, 1.0)},
        Field{"sliding_friction", &Material::sliding_friction, "1", Bounds::not_negative()},
        Field{"rolling_friction", &Material::rolling_friction, "1", Bounds::not_negative()},
        Field{"rolling_stiffness", &Material::rolling_stiffness, "1", Bounds::at_least(1.0)},
        Field{"rolling_viscous_damping", &Material::rolling_viscous_damping, "1", Bounds::not_negative()}};
  }
};
static_assert(lists_every_member<Material>());

}  // namespace flowslide
