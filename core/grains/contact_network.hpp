// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <vector>

#include "grains/assembly.hpp"

namespace flowslide {

/// Measures of the contact network of the mobile grains. Contacts with grains of any role count; contacts with planes
/// and pairs of one glued layer do not. A rattler has at most one contact and bears no load (C. Thornton, Geotechnique
/// 50 (2000) 43-53).
struct ContactNetwork {
  double coordination_number = 0.0;             ///< mean number of contacts
  double mechanical_coordination_number = 0.0;  ///< the same without rattlers
  double rattler_share = 0.0;                   ///< rattlers as a fraction of the mobile grains
  /// sqrt(3/2 d:d), with d the deviator of the mean of n (x) n over the contacts, n their unit normals. 0: isotropic;
  /// 1: all normals have one direction.
  double fabric_anisotropy = 0.0;
  std::vector<double> shares;  ///< fractions of the mobile grains with 0, 1, 2, ... contacts; their sum is 1
};

/// Measures the network; all members are 0 without mobile grains.
ContactNetwork contact_network(const Assembly& assembly);

}  // namespace flowslide
