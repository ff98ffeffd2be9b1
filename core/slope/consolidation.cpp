// SPDX-License-Identifier: GPL-2.0-or-later
#include "slope/consolidation.hpp"

#include <cmath>
#include <limits>

#include "slope/require.hpp"

namespace flowslide {
namespace {

void require_modulus(double modulus) {
  require_positive("oedometric modulus of the sample", modulus, "Pa", "Give an upper bound, such as 100 MPa.");
}

}  // namespace

double consolidation_coefficient(const SlopeProperties& slope) {
  validate(slope);
  const double drained_height = slope.liquefiable_thickness * std::cos(slope.angle);
  return 2.0 * slope.hydraulic_conductivity / (slope.unit_weight_of_water() * drained_height * drained_height);
}

Consolidation::Consolidation(const SlopeProperties& slope, ConsolidationScheme scheme, double time_step, double modulus)
    : strain_per_excess_(consolidation_coefficient(slope) * time_step), predicted_modulus_(0.0) {
  require_positive("time step dt_G", time_step, "s", "Give one such as 1e-4 s.");
  if (scheme == ConsolidationScheme::euler) return;
  require_modulus(modulus);
  strain_per_excess_ = -std::expm1(-strain_per_excess_ * modulus) / modulus;
  predicted_modulus_ = modulus;
}

double Consolidation::increment(double excess, double owed_strain) const {
  return strain_per_excess_ * (excess - predicted_modulus_ * owed_strain);
}

double consolidation_time_step_limit(const SlopeProperties& slope, double oedometric_modulus) {
  require_modulus(oedometric_modulus);
  const double coefficient = consolidation_coefficient(slope);
  return coefficient > 0.0 ? 2.0 / (oedometric_modulus * coefficient) : std::numeric_limits<double>::infinity();
}

}  // namespace flowslide
