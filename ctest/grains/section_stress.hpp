// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "grains/contact_forces.hpp"

namespace flowslide::testing {

/// Sum of the forces (N) of a glued layer and of the plane behind it on the mobile grains.
inline Vector3 force_on_mobile(const Assembly& assembly, const ContactForces& forces, Role layer) {
  Vector3 sum = Vector3::Zero();
  for (const Contact& contact : forces.contacts) {
    const Role first = assembly.role[contact.first], second = assembly.role[contact.second];
    if (first == Role::mobile && second == layer) sum += contact.force.on_first;
    if (first == layer && second == Role::mobile) sum -= contact.force.on_first;
  }
  for (const PlaneContact& contact : forces.plane_contacts)
    if (contact.axis == 2 && contact.upper == (layer == Role::top_layer)) sum += contact.force_on_grain;
  return sum;
}

/// z row (sigma_zx, sigma_zy, sigma_zz), Pa, compression positive, of Bagi's stress (eq. 12) without a loop over pairs:
///   sigma_z. = [ sum over mobile grains of z f - H F_top ] / V,
/// z from the bottom plane, H the height of the cell, f = assembly.force and F_top the force of the top boundary on the
/// mobile grains. sigma_zz is exact always; sigma_zx and sigma_zy only where the axis x or y is periodic, since the
/// planes of a rigid lateral axis push the grains but carry no stress on horizontal sections.
inline Vector3 section_stress(const Assembly& assembly, const Vector3& top_on_mobile) {
  Vector3 sum = -assembly.cell.height() * top_on_mobile;
  for (std::size_t i = 0; i < assembly.size(); ++i)
    if (assembly.role[i] == Role::mobile)
      sum += (assembly.position[i].z() - assembly.cell.lower.z()) * assembly.force[i];
  return sum / assembly.cell.volume();
}

}  // namespace flowslide::testing
