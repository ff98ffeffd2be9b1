// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "sample/sample.hpp"

namespace flowslide {

/// Properties of a linear sample. The default moduli are of the order of those of a dense packing at 28 kPa.
struct ElasticProperties {
  double shear_modulus = 15e6;       ///< G, Pa, > 0
  double oedometric_modulus = 40e6;  ///< M, Pa, > 0
  double viscosity = 0.0;            ///< eta, shear viscosity, Pa s, >= 0
  double shear_stress = 2.65e3;      ///< tau at zero strain, Pa
  double normal_stress = 28.34e3;    ///< sigma at zero strain, Pa
  double void_ratio = 0.77;          ///< e at zero strain, > 0
};

/// A linear sample for tests with an exact solution (Kelvin's solid in shear, Hooke's in compression):
///   tau = tau_0 + G gamma + eta d(gamma)/dt_L,   sigma = sigma_0 + M epsilon.
/// The rate refers to the local clock. If a rule passes strain at a wrong rate, tau shows it.
class ElasticSample : public Sample {
 public:
  /// Throws std::invalid_argument if a value is out of its range.
  explicit ElasticSample(const ElasticProperties& properties);

  CellStress strain(const LocalRun& run) override;
  CellStress stress() const override;
  double mean_stress() const override { return stress().mean(); }
  double shear_strain() const override { return shear_strain_; }
  double void_ratio() const override { return void_ratio_; }
  SampleState state() const override;
  void restore(const SampleState& state) override;

 private:
  ElasticProperties properties_;
  double shear_strain_ = 0.0, compression_ = 0.0, shear_rate_ = 0.0;
  double void_ratio_;
};

}  // namespace flowslide
