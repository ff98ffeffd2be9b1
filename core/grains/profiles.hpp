// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <vector>

#include "grains/contact_forces.hpp"

namespace flowslide {

/// Profiles of velocity and stress over the height (Fig. 10), in equal sublayers from the bottom to the top of the
/// cell. All arrays have shape (sublayers).
struct Profiles {
  std::vector<double> height;         ///< middle of each sublayer, m above the bottom
  std::vector<double> velocity;       ///< <v_x>, m/s, positive downslope, relative to the bottom: mean over the solid
                                      ///< volume in the sublayer. The bottom of a sheared cell (see Cell) is its lower
                                      ///< face, which moves with minus the velocity of its upper face
  std::vector<double> shear_stress;   ///< <tau>, Pa, positive downslope (see slab_stress)
  std::vector<double> normal_stress;  ///< <sigma>, Pa, compression positive
};

/// Computes the profiles. The stress of the two outer sublayers is too low: they are partly behind the glued layers,
/// whose contacts with the planes do not count. Throws std::invalid_argument for sublayers < 1 or for a sublayer
/// without solid.
Profiles profiles(const Assembly& assembly, const ContactForces& forces, int sublayers);

}  // namespace flowslide
