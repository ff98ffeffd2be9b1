// SPDX-License-Identifier: GPL-2.0-or-later
#include "coupling/stress_reading.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sample/failure.hpp"

namespace flowslide {

StressReading::StressReading(ResidualTreatment treatment, const BasalStress& balance, const CellStress& prepared)
    : treatment_(treatment),
      residual_{balance.shear - prepared.shear, balance.normal - prepared.normal},
      prepared_normal_(prepared.normal) {
  if (treatment == ResidualTreatment::stays) return;
  const double share = std::max(std::abs(residual_.shear), std::abs(residual_.normal)) / balance.normal;
  if (prepared.normal > 0.0 && share <= largest_residual) return;
  throw NumericalFailure(
      fmt::format("the sample has tau = {:.6g} Pa and sigma = {:.6g} Pa, and the slope begins with {:.6g} Pa and "
                  "{:.6g} Pa (eqs 8 and 9): they may differ by {} of the slope's normal stress at most; prepare the "
                  "sample to the stresses of this slope",
                  prepared.shear, prepared.normal, balance.shear, balance.normal, largest_residual));
}

BasalStress StressReading::read(const CellStress& sample) const {
  double share = 0.0;
  if (treatment_ == ResidualTreatment::fades) share = sample.normal / prepared_normal_;
  if (treatment_ == ResidualTreatment::stays) share = 1.0;
  return {sample.shear + share * residual_.shear, sample.normal + share * residual_.normal};
}

}  // namespace flowslide
