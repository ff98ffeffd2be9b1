// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <cmath>

namespace flowslide {

/// Strain of the liquefiable layer or of a sample, or an increment of it.
struct Strain {
  double shear = 0.0;        ///< gamma, positive downslope
  double compression = 0.0;  ///< epsilon, positive when the layer becomes thinner

  /// ||(gamma, epsilon)||, the norm of eqs 15 to 18.
  double norm() const { return std::hypot(shear, compression); }

  Strain& operator+=(const Strain& other) {
    shear += other.shear;
    compression += other.compression;
    return *this;
  }
  friend Strain operator*(double factor, const Strain& strain) {
    return {factor * strain.shear, factor * strain.compression};
  }
};

}  // namespace flowslide
