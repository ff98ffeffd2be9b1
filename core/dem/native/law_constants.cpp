// SPDX-License-Identifier: GPL-2.0-or-later
#include "dem/native/law_constants.hpp"

#include "grains/material.hpp"
#include "grains/pair_constants.hpp"

namespace flowslide::native {

LawVariant variant_of(const Material& material) {
  if (material.rolling_friction > 0.0) return LawVariant::sliding_and_rolling;
  return material.sliding_friction > 0.0 ? LawVariant::sliding : LawVariant::frictionless;
}

template <typename Real>
LawConstants<Real> law_constants(const Material& material, double time_step) {
  const PairConstants pair = pair_constants(material, 1.0, 1.0);  // moduli and damping do not depend on the radii
  LawConstants<Real> constants{};
  constants.law = material.contact_law;
  constants.variant = variant_of(material);
  constants.time_step = static_cast<Real>(time_step);
  visit_law(material.contact_law, [&]<typename Law>(Law) {
    using Normal = typename Law::Normal;
    using Tangential = typename Law::Tangential;
    using Rolling = typename Law::Rolling;
    const double stiffness = Normal::template constants<double>(material, pair).normal;
    static_cast<typename Normal::template Constants<Real>&>(constants) =
        Normal::template constants<Real>(material, pair);
    static_cast<typename Tangential::template Constants<Real>&>(constants) =
        Tangential::template constants<Real>(material);
    static_cast<typename Rolling::template Constants<Real>&>(constants) =
        Rolling::template constants<Real>(material, stiffness);
  });
  return constants;
}

bool has_constant_scale(ContactLaw law) {
  return visit_law(law, []<typename Law>(Law) { return Law::Normal::scale_is_constant; });
}

double constant_root_scale(ContactLaw law, double effective_radius, double effective_mass) {
  return visit_law(law, [&]<typename Law>(Law) {
    if constexpr (Law::Normal::scale_is_constant) return Law::Normal::root_scale(effective_radius, effective_mass);
    return 0.0;
  });
}

template <typename Real>
LawConstants<Real> with_scaled_caps(LawConstants<Real> constants, Real factor) {
  constants.time_step = 0;
  visit_law(constants.law, [&]<typename Law>(Law) {
    static_cast<typename Law::Tangential::template Constants<Real>&>(constants).scale_cap(factor);
    if constexpr (Law::Rolling::has_history)
      static_cast<typename Law::Rolling::template Constants<Real>&>(constants).scale_cap(factor);
  });
  return constants;
}

template LawConstants<double> law_constants<double>(const Material&, double);
template LawConstants<float> law_constants<float>(const Material&, double);
template LawConstants<double> with_scaled_caps<double>(LawConstants<double>, double);
template LawConstants<float> with_scaled_caps<float>(LawConstants<float>, float);

}  // namespace flowslide::native
