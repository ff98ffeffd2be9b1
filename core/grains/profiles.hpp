// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <vector>

#include "grains/contact_forces.hpp"

namespace flowslide {

/// How velocity and stress change with height (Fig. 10), over equal sublayers from the bottom to the top of the cell.
/// All arrays have shape (sublayers).
struct Profiles {
  std::vector<double> height;         ///< z of the middle of each, m above the bottom
  std::vector<double> velocity;       ///< <v_x>, m/s, positive downslope, relative to the bottom: mean over the solid volume in
                                      ///< the sublayer. The lower face of a sheared cell (see Cell) is its bottom, and
                                      ///< moves as fast as its upper face, to the other side
  std::vector<double> shear_stress;   ///< <tau>, Pa, positive downslope (see slab_stress)
  std::vector<double> normal_stress;  ///< <sigma>, Pa, compression positive
};

/// Throws std::invalid_argument if there are no sublayers, or one of them holds no solid. The outer two lie partly
/// behind the glued layers, whose contacts with the planes do not count: their stresses are low by that part.
Profiles profiles(const Assembly& assembly, const ContactForces& forces, int sublayers);

}  // namespace flowslide
