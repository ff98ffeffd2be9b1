// SPDX-License-Identifier: GPL-2.0-or-later
#include "sample/elastic_sample.hpp"

#include "grains/require.hpp"

namespace flowslide {

ElasticSample::ElasticSample(const ElasticProperties& properties)
    : properties_(properties), void_ratio_(properties.void_ratio) {
  require(properties.shear_modulus > 0.0, "shear modulus of the elastic sample", properties.shear_modulus, "> 0 Pa",
          "Give G, such as 15 MPa.");
  require(properties.oedometric_modulus > 0.0, "oedometric modulus of the elastic sample",
          properties.oedometric_modulus, "> 0 Pa", "Give M, such as 40 MPa.");
  require(properties.viscosity >= 0.0, "viscosity of the elastic sample", properties.viscosity, ">= 0 Pa s",
          "Use 0 for a sample without one.");
  require(properties.void_ratio > 0.0, "void ratio of the elastic sample", properties.void_ratio, "> 0",
          "Give one such as 0.77.");
}

CellStress ElasticSample::strain(const LocalRun& run) {
  validate(run);
  const double compression = run.rate.compression * run.duration();
  shear_strain_ += run.rate.shear * run.duration();
  compression_ += compression;
  void_ratio_ = (1.0 + void_ratio_) * (1.0 - compression) - 1.0;
  if (run.steps > 0) shear_rate_ = run.rate.shear;
  return stress();
}

CellStress ElasticSample::stress() const {
  const double normal = properties_.normal_stress + properties_.oedometric_modulus * compression_;
  const double shear =
      properties_.shear_stress + properties_.shear_modulus * shear_strain_ + properties_.viscosity * shear_rate_;
  return {normal, shear, 0.0, normal, normal};
}

SampleState ElasticSample::state() const {
  return {{{"shear_strain", shear_strain_},
           {"compression", compression_},
           {"shear_rate", shear_rate_},
           {"void_ratio", void_ratio_}},
          {}};
}

void ElasticSample::restore(const SampleState& state) {
  shear_strain_ = state.number("shear_strain");
  compression_ = state.number("compression");
  shear_rate_ = state.number("shear_rate");
  void_ratio_ = state.number("void_ratio");
}

}  // namespace flowslide
