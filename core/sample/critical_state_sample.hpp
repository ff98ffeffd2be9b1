// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "sample/sample.hpp"

namespace flowslide {

/// Properties of a sample with critical-state friction. Symbols as in the source (see CriticalStateSample).
struct CriticalStateProperties {
  double critical_friction = 0.4;        ///< M, tau/sigma in steady shearing, > 0
  double critical_void_ratio = 0.77;     ///< e_Gamma, e in steady shearing at the reference stress, > 0
  double critical_slope = 0.01;          ///< lambda, slope of e_c over ln(sigma), > 0
  double reference_stress = 28.34e3;     ///< sigma_r, Pa, > 0
  double shear_stiffness = 500.0;        ///< G/sigma, > 0
  double oedometric_stiffness = 1400.0;  ///< M_o/sigma, > 0
  double hardening = 0.5;                ///< h, > 0
  double peak_exponent = 1.1;            ///< n, >= 0; a larger n gives dense samples more friction
  double dilatancy = 0.3;                ///< d_0, >= 0
  double dilatancy_exponent = 3.5;       ///< m, >= 0; a larger m makes loose samples contract more

  double shear_stress = 2.65e3;          ///< tau before strain, Pa; |tau|/sigma < M exp(-n psi)
  double normal_stress = 28.34e3;        ///< sigma before strain, Pa, > 0
  double void_ratio = 0.79;              ///< e before strain, > 0
  double largest_substep = 1e-6;         ///< strain of one explicit step of the integration, > 0
};

/// Sand in simple shear whose friction and dilatancy depend on the distance to the critical state. The model is that of
/// X. S. Li and Y. F. Dafalias, Dilatancy for cohesionless soils, Geotechnique 50 (2000) 449-460, with sigma, tau and
/// gamma in place of p, q and the deviatoric strain. eta = tau/sigma, and psi is the state parameter (Been and
/// Jefferies):
///   psi = e - e_c,   e_c = e_Gamma - lambda ln(sigma/sigma_r).
/// The sample shears plastically while N > 0 (see below), which means loading in the direction of tau. Otherwise
/// d_gamma_p = 0:
///   d(tau) = G (d_gamma - d_gamma_p),   d(sigma) = M_o (d_epsilon - d_epsilon_p),
///   sigma d(eta) = K d_gamma_p,         K = h G (M exp(-n psi)/eta - 1),
///   d_epsilon_p = d d_gamma_p,          d = d_0 (exp(m psi) - eta/M), positive when the sample contracts.
/// Deviations from the source: the moduli are proportional to sigma, as in Cam clay, so that a liquefied sample
/// approaches sigma = 0 and never passes it; and e_c is linear in ln(sigma). The sample is rate-independent. As coded:
///   N = G d_gamma - eta M_o d_epsilon,  B = h G (M exp(-n psi) - eta),  D = B + eta (G - eta M_o d),
///   d_gamma_p = eta N/D, d(eta) = B N/(sigma D).
/// The coded form holds at eta = 0 as well. Range of validity: |psi| up to about 0.1, D > 0.
class CriticalStateSample : public Sample {
 public:
  /// Throws std::invalid_argument if a value is out of its range.
  explicit CriticalStateSample(const CriticalStateProperties& properties);

  /// Throws NumericalFailure where the model has no answer (D <= 0).
  CellStress strain(const LocalRun& run) override;
  CellStress stress() const override;
  double mean_stress() const override { return stress().mean(); }
  double shear_strain() const override { return shear_strain_; }
  double void_ratio() const override { return void_ratio_; }
  SampleState state() const override;
  void restore(const SampleState& state) override;

  /// Present psi: positive when the sample is looser than at the critical state.
  double state_parameter() const;

 private:
  void substep(double shear, double compression);

  CriticalStateProperties properties_;
  double normal_stress_, stress_ratio_, void_ratio_;
  double shear_strain_ = 0.0;
};

}  // namespace flowslide
