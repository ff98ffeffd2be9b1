// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "grains/assembly.hpp"
#include "grains/contact_law.hpp"
#include "grains/material.hpp"

namespace flowslide {

/// One touching pair with its force, first < second.
struct Contact {
  std::uint32_t first = 0, second = 0;
  double overlap = 0.0;                               ///< m
  Vector3 branch = Vector3::Zero();                   ///< x_first - x_second, nearest image, m
  Vector3 point_from_first = Vector3::Zero();         ///< contact point minus the centre of the first, m
  Vector3 point_from_second = Vector3::Zero();        ///< contact point minus the centre of the second, m
  ContactForce force;
};

/// Contact of a mobile grain with a plane of the cell.
struct PlaneContact {
  std::uint32_t grain = 0;
  int axis = 0;                                       ///< 0, 1, 2 for x, y, z
  bool upper = false;                                 ///< true: the plane at cell.upper[axis]
  double overlap = 0.0;                               ///< m
  Vector3 point_from_grain = Vector3::Zero();         ///< projection of the centre on the plane minus the centre, m
  Vector3 force_on_grain = Vector3::Zero();           ///< N, along the axis
};

/// Normal velocities (m/s, along the positive axis) of the six planes; shape (3) each.
struct PlaneVelocities {
  std::array<double, 3> lower{0.0, 0.0, 0.0}, upper{0.0, 0.0, 0.0};
};

/// All contact forces of an assembly.
struct ContactForces {
  std::vector<Contact> contacts;                      ///< sorted by (first, second), without pairs of one glued layer
  std::vector<PlaneContact> plane_contacts;           ///< sorted by grain
};

/// Forces and torques on each grain, shape (n) each.
struct GrainForces {
  std::vector<Vector3> force;                         ///< N
  std::vector<Vector3> torque;                        ///< N m
};

/// The contact forces at the end of the last step, from the stored histories. A touching pair without history has
/// unloaded springs. Dashpots use the velocities of the half step, as in the velocity-Verlet scheme of the engines:
///   v_half = v - dt/2 f/m,   w_half = w - dt/2 T/I_s
/// with force and torque of the assembly. This holds for mobile grains; glued grains keep v and w. The planes of rigid
/// axes act on mobile grains only. Images of a sheared cell have the shift and the velocity that the cell states.
/// `time_step` is dt (s); 0 uses the velocities of the full step.
///
/// The forces agree with those of the step up to rounding: within 1e-10 of the largest contact force for the native
/// engine in double, within 2e-6 with its law in float.
ContactForces evaluate_contact_forces(const Assembly& assembly, const Material& material, double time_step,
                                      const PlaneVelocities& planes = {});

/// Sums of the contact forces and torques on each of `grain_count` grains.
GrainForces sum_on_grains(const ContactForces& forces, std::size_t grain_count);

}  // namespace flowslide
