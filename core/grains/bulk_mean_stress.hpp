// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "grains/contact_forces.hpp"

namespace flowslide {

/// Mean stress p for an inertial number, Pa, compression positive: the contact stress of the bulk (see bulk_stress)
/// plus the kinetic stress (eq. 14). The contact part is at least 0, because dashpots may pull briefly when few
/// contacts are left. The kinetic part keeps p above 0 when no contact is left.
double bulk_mean_stress(const Assembly& assembly, const ContactForces& forces, const Material& material);

}  // namespace flowslide
