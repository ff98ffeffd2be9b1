// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "grains/laws/contact_laws.hpp"

namespace flowslide {
struct Material;
}

namespace flowslide::native {

template <typename Real, typename Parts>
struct ConstantsOf;
template <typename Real, typename... Parts>
struct ConstantsOf<Real, laws::List<Parts...>> : Parts::template Constants<Real>... {};

/// The parts of the law that a scene needs.
enum class LawVariant { frictionless, sliding, sliding_and_rolling };

/// Constants of the parts of all laws, for the pairs of one material. A part reads its own base.
template <typename Real>
struct LawConstants : ConstantsOf<Real, laws::Parts> {
  ContactLaw law;
  LawVariant variant;
  Real time_step;  ///< dt_L, s

  template <typename Part>
  const typename Part::template Constants<Real>& of() const {
    return *this;
  }
};

/// The variant for a material: without friction it has no sliding part, and without rolling friction no rolling part.
LawVariant variant_of(const Material& material);

/// The constants for a material and a time step (s).
template <typename Real>
LawConstants<Real> law_constants(const Material& material, double time_step);

/// Whether the scale s of the law is constant for a pair (see grains/laws/lane.hpp).
bool has_constant_scale(ContactLaw law);

/// sqrt(s) of a pair with R* (m) and m* (kg) for such a law; 0 for another.
double constant_root_scale(ContactLaw law, double effective_radius, double effective_mass);

/// The same law for a step of 0 with all caps multiplied by `factor`.
template <typename Real>
LawConstants<Real> with_scaled_caps(LawConstants<Real> constants, Real factor);

}  // namespace flowslide::native
