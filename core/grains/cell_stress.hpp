// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

namespace flowslide {

/// Mean stress of the cell from contacts (no kinetic part, no drag), Pa. Compression is positive. Shear is positive
/// when the top drags the sample towards +x (downslope).
struct CellStress {
  double normal = 0.0;      ///< sigma = sigma_zz
  double shear = 0.0;       ///< tau = -sigma_zx, see slope_stress
  double transverse = 0.0;  ///< -sigma_zy, likewise
  double lateral_x = 0.0;   ///< sigma_xx
  double lateral_y = 0.0;   ///< sigma_yy

  /// p, the mean stress.
  double mean() const { return (normal + lateral_x + lateral_y) / 3.0; }
};

}  // namespace flowslide
