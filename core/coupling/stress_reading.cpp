// SPDX-License-Identifier: GPL-2.0-or-later
#include "coupling/stress_reading.hpp"

#include <algorithm>
#include <cmath>

#include "grains/require.hpp"

namespace flowslide {

StressReading::StressReading(ResidualTreatment treatment, const BasalStress& balance, const CellStress& prepared)
    : treatment_(treatment),
      residual_{balance.shear - prepared.shear, balance.normal - prepared.normal},
      prepared_normal_(prepared.normal) {
  if (treatment == ResidualTreatment::stays) return;
  require(prepared.normal > 0.0, "normal stress of the sample", prepared.normal, "> 0 Pa",
          "Prepare it to the stresses of the slope.");
  const double share = std::max(std::abs(residual_.shear), std::abs(residual_.normal)) / balance.normal;
  require(share <= largest_residual, "distance of the sample from the slope's stresses over its normal stress", share,
          "at most " + std::to_string(largest_residual),
          "Prepare the sample to tau_0 and sigma_0 of this slope (eqs 8 and 9).");
}

BasalStress StressReading::read(const CellStress& sample) const {
  double share = 0.0;
  if (treatment_ == ResidualTreatment::fades) share = sample.normal / prepared_normal_;
  if (treatment_ == ResidualTreatment::stays) share = 1.0;
  return {sample.shear + share * residual_.shear, sample.normal + share * residual_.normal};
}

}  // namespace flowslide
