// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "grains/contact_forces.hpp"

namespace flowslide {

/// p, Pa, compression positive, that an inertial number is built on: of the bulk (see bulk_stress), at least zero as
/// dashpots may pull for a moment when hardly a contact is left, and of the fluctuating velocities (eq. 14), which keep
/// it above zero when none is.
double bulk_mean_stress(const Assembly& assembly, const ContactForces& forces, const Material& material);

}  // namespace flowslide
