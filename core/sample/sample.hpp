// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <cstdint>

#include "dem/engine.hpp"

namespace flowslide {

/// Rates at which a sample is strained, 1/s, per present height.
struct StrainRate {
  double shear = 0.0;        ///< gamma rate, positive when the top moves downslope (+x)
  double compression = 0.0;  ///< epsilon rate, positive when the sample becomes thinner; 0 keeps the volume
};

/// A piece of soil that answers strain with stress: the constitutive law of the slope.
class Sample {
 public:
  virtual ~Sample() = default;
  /// Strains the sample for `steps` local time steps and returns the stress at their end. Throws NumericalFailure.
  virtual CellStress strain(const StrainRate& rate, std::int64_t steps) = 0;
  virtual CellStress stress() const = 0;
  virtual double shear_strain() const = 0;  ///< gamma since the sample was prepared
  virtual double void_ratio() const = 0;
};

}  // namespace flowslide
