// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "grains/fields.hpp"
#include "grains/laws/contact_laws.hpp"

namespace flowslide {

/// Properties of the grains themselves, which all contact laws share. Defaults are those of Table 1 of the paper.
struct GrainProperties {
  double density = 2650.0;                  ///< rho, kg/m^3, of the solid
  double youngs_modulus = 2.0e9;            ///< E, Pa
  double poisson_ratio = 0.25;              ///< nu
  double restitution = 0.8;                 ///< coefficient of restitution, in (0, 1]
  ContactLaw contact_law = ContactLaw::hertz;

  bool operator==(const GrainProperties&) const = default;
  static constexpr auto fields() {
    return std::tuple{Field{"density", &GrainProperties::density, "kg/m^3", Bounds::positive()},
                      Field{"youngs_modulus", &GrainProperties::youngs_modulus, "Pa", Bounds::positive()},
                      Field{"poisson_ratio", &GrainProperties::poisson_ratio, "1", Bounds::from_below(0.0, 0.5)},
                      Field{"restitution", &GrainProperties::restitution, "1", Bounds::above_up_to(0.0, 1.0)},
                      Field{"contact_law", &GrainProperties::contact_law}};
  }
};
static_assert(lists_every_member<GrainProperties>());

/// Properties of the grains and the parameters of their contact law. Each part of a law declares its own (see
/// grains/laws).
struct Material : GrainProperties, laws::ParametersOf<laws::Parts> {
  bool operator==(const Material&) const = default;
  /// G = E / (2 (1 + nu)), Pa.
  double shear_modulus() const { return youngs_modulus / (2.0 * (1.0 + poisson_ratio)); }
  /// Whether the contact law reads the field of this name. Other fields have no effect; they are neither read from a
  /// configuration nor checked nor part of a recipe.
  bool uses(const char* field) const { return uses_parameter(contact_law, field); }

  static constexpr auto fields() {
    return std::tuple_cat(GrainProperties::fields(), laws::ParametersOf<laws::Parts>::fields());
  }
};

}  // namespace flowslide
