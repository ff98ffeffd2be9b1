// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <vector>

#include "grains/assembly.hpp"

namespace flowslide {

/// What the contacts of the mobile grains with grains of any role are like; planes and pairs of one glued layer are
/// left out. A rattler has at most one contact, and carries nothing (C. Thornton, Geotechnique 50 (2000) 43-53).
struct ContactNetwork {
  double coordination_number = 0.0;             ///< mean number of contacts
  double mechanical_coordination_number = 0.0;  ///< of the grains that are no rattlers
  double rattler_share = 0.0;                   ///< of the mobile grains
  /// sqrt(3/2 d:d) of the deviator d of the mean of n n over the contacts, n their unit normals: 0 of directions alike,
  /// 1 of one direction.
  double fabric_anisotropy = 0.0;
  std::vector<double> shares;  ///< of the mobile grains with 0, 1, 2, ... contacts; sum 1
};

/// All zero without mobile grains.
ContactNetwork contact_network(const Assembly& assembly);

}  // namespace flowslide
