// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "grains/contact_forces.hpp"

namespace flowslide {

/// Stress, Pa, compression positive, of the slab lower <= z <= upper (m), from the contacts between grains:
///   sigma_ij = 1/(A (upper - lower)) sum_c w_c l_i^c f_j^c,
/// with w_c the fraction of the branch l^c between the two centres that is in the slab. The mean over slabs that fill
/// the space between the glued layers agrees with the stress of the cell (Weinhart et al. 2012, doi
/// 10.1007/s10035-012-0317-4, with a slab as coarse-graining function). Contacts with planes do not count. Throws
/// std::invalid_argument unless lower < upper.
Matrix3 slab_stress(const Assembly& assembly, const ContactForces& forces, double lower, double upper);

/// Stress of the bulk, Pa: the part of the sample at least one mean diameter away from the z planes. It excludes grains
/// that are wedged in the glued layers, because their horizontal forces remain after liquefaction. In a cell that is
/// periodic along z all grains belong to the bulk.
Matrix3 bulk_stress(const Assembly& assembly, const ContactForces& forces);

}  // namespace flowslide
