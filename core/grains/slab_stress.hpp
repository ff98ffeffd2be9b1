// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "grains/contact_forces.hpp"

namespace flowslide {

/// Stress, Pa, compression positive, of the slab lower <= z <= upper (m), from the contacts between grains:
///   sigma_ij = 1/(A (upper - lower)) sum_c w_c l_i^c f_j^c,
/// w_c the share of the branch l^c between the two centres that lies in the slab. Slabs that fill the space between the
/// glued layers and the cell's stress agree in the mean (Weinhart et al. 2012, doi 10.1007/s10035-012-0317-4, with a
/// slab for the coarse-graining function). Contacts with planes are left out. Throws std::invalid_argument unless
/// lower < upper.
Matrix3 slab_stress(const Assembly& assembly, const ContactForces& forces, double lower, double upper);

/// Stress of the part of the sample that is a mean diameter or more away from the z planes. Glued layers hold wedged
/// grains whose horizontal forces survive liquefaction; they are not part of it. A cell that is periodic along z has none,
/// and is bulk as a whole.
Matrix3 bulk_stress(const Assembly& assembly, const ContactForces& forces);

}  // namespace flowslide
