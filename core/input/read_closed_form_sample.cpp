// SPDX-License-Identifier: GPL-2.0-or-later
#include "input/read_closed_form_sample.hpp"

#include "configuration/error.hpp"
#include "sample/critical_state_sample.hpp"
#include "sample/elastic_sample.hpp"

namespace flowslide {
namespace {

ElasticProperties read_elastic(const Configuration& configuration) {
  ElasticProperties sample;
  sample.shear_modulus = configuration.quantity("elastic.shear_modulus", dimension::stress, Range::positive());
  sample.oedometric_modulus =
      configuration.quantity("elastic.oedometric_modulus", dimension::stress, Range::positive());
  sample.viscosity = configuration.quantity("elastic.viscosity", dimension::viscosity, Range::not_negative());
  sample.void_ratio = configuration.number("elastic.void_ratio", Range::positive());
  return sample;
}

CriticalStateProperties read_critical_state(const Configuration& configuration) {
  const auto number = [&](const std::string& key, const Range& range) {
    return configuration.number("critical_state." + key, range);
  };
  CriticalStateProperties sample;
  sample.critical_friction = number("critical_friction", Range::positive());
  sample.critical_void_ratio = number("critical_void_ratio", Range::positive());
  sample.critical_slope = number("critical_slope", Range::positive());
  sample.reference_stress =
      configuration.quantity("critical_state.reference_stress", dimension::stress, Range::positive());
  sample.shear_stiffness = number("shear_stiffness", Range::positive());
  sample.oedometric_stiffness = number("oedometric_stiffness", Range::positive());
  sample.hardening = number("hardening", Range::positive());
  sample.peak_exponent = number("peak_exponent", Range::not_negative());
  sample.dilatancy = number("dilatancy", Range::not_negative());
  sample.dilatancy_exponent = number("dilatancy_exponent", Range::not_negative());
  sample.void_ratio = number("void_ratio", Range::positive());
  return sample;
}

}  // namespace

std::unique_ptr<Sample> read_closed_form_sample(const Configuration& configuration, const std::string& name,
                                                const SlopeProperties& slope) {
  const auto in_balance = [&](auto sample) {
    sample.shear_stress = initial_shear_stress(slope);
    sample.normal_stress = initial_normal_stress(slope);
    return sample;
  };
  return as_written_by_user(configuration.place_of({name, "slope"}), [&]() -> std::unique_ptr<Sample> {
    if (name == "elastic") return std::make_unique<ElasticSample>(in_balance(read_elastic(configuration)));
    if (name == "critical_state")
      return std::make_unique<CriticalStateSample>(in_balance(read_critical_state(configuration)));
    throw ConfigurationError("\"" + name + "\" is no closed-form sample; there are elastic and critical_state");
  });
}

}  // namespace flowslide
