// SPDX-License-Identifier: GPL-2.0-or-later
#include "grains/contact_forces.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

#include "grains/contact_search.hpp"

namespace flowslide {
namespace {

struct HalfStep {
  std::vector<Vector3> velocity, spin;
};

HalfStep half_step_velocities(const Assembly& assembly, const Material& material, double time_step) {
  HalfStep half{assembly.velocity, assembly.spin};
  for (std::size_t i = 0; i < assembly.size(); ++i) {
    if (assembly.role[i] != Role::mobile) continue;
    half.velocity[i] -= 0.5 * time_step / sphere_mass(assembly.radius[i], material) * assembly.force[i];
    half.spin[i] -= 0.5 * time_step / sphere_inertia(assembly.radius[i], material) * assembly.torque[i];
  }
  return half;
}

/// The stored history of a pair; unloaded springs if there is none.
ContactHistory history_of(const Assembly& assembly, const TouchingPair& pair) {
  const auto before = [](const ContactHistory& a, const TouchingPair& b) {
    return std::pair(a.first, a.second) < std::pair(b.first, b.second);
  };
  const auto found = std::lower_bound(assembly.contacts.begin(), assembly.contacts.end(), pair, before);
  const bool stored = found != assembly.contacts.end() && found->first == pair.first && found->second == pair.second;
  return stored ? *found : ContactHistory{pair.first, pair.second, Vector3::Zero(), Vector3::Zero()};
}

Contact evaluate_pair(const Assembly& assembly, const Material& material, const HalfStep& half,
                      const TouchingPair& pair) {
  const auto [i, j] = pair;
  Contact contact;
  contact.first = i;
  contact.second = j;
  const Vector3 apart = assembly.position[i] - assembly.position[j];
  contact.branch = assembly.cell.nearest_image(apart);
  const double distance = contact.branch.norm();
  contact.overlap = assembly.radius[i] + assembly.radius[j] - distance;
  ContactKinematics motion;
  motion.normal = contact.branch / distance;
  motion.overlap = contact.overlap;
  motion.relative_velocity = half.velocity[i] - half.velocity[j] - assembly.cell.nearest_image_velocity(apart);
  motion.spin_first = half.spin[i];
  motion.spin_second = half.spin[j];
  contact.point_from_first = -(assembly.radius[i] - 0.5 * contact.overlap) * motion.normal;
  contact.point_from_second = (assembly.radius[j] - 0.5 * contact.overlap) * motion.normal;
  const ContactHistory history = history_of(assembly, pair);
  contact.force = stored_contact(material, pair_constants(material, assembly.radius[i], assembly.radius[j]), motion,
                                 {{history.tangential_spring, history.spring_cap},
                                  {history.rolling_torque, history.torque_cap}});
  return contact;
}

/// The contacts of one grain with the planes of the rigid axes.
std::vector<PlaneContact> plane_contacts(const Assembly& assembly, const Material& material, const HalfStep& half,
                                         const PlaneVelocities& planes, std::uint32_t grain) {
  std::vector<PlaneContact> contacts;
  const double radius = assembly.radius[grain];
  const Cell& cell = assembly.cell;
  for (int axis = 0; axis < 3; ++axis) {
    if (cell.periodic[axis]) continue;
    for (const bool upper : {false, true}) {
      const double inward = upper ? -1.0 : 1.0;
      const double plane = upper ? cell.upper[axis] : cell.lower[axis];
      const double distance = inward * (assembly.position[grain][axis] - plane);
      if (distance >= radius) continue;
      const double plane_velocity = upper ? planes.upper[axis] : planes.lower[axis];
      const double approach = inward * (plane_velocity - half.velocity[grain][axis]);
      const double force =
          plane_normal_force(material, radius, sphere_mass(radius, material), radius - distance, approach);
      const Vector3 normal = inward * Vector3::Unit(axis);
      contacts.push_back({grain, axis, upper, radius - distance, -distance * normal, force * normal});
    }
  }
  return contacts;
}

}  // namespace

ContactForces evaluate_contact_forces(const Assembly& assembly, const Material& material, double time_step,
                                      const PlaneVelocities& planes) {
  const HalfStep half = half_step_velocities(assembly, material, time_step);
  ContactForces forces;
  for (const TouchingPair& pair : touching_pairs(assembly))
    forces.contacts.push_back(evaluate_pair(assembly, material, half, pair));
  for (std::uint32_t grain = 0; grain < assembly.size(); ++grain)
    if (assembly.role[grain] == Role::mobile)
      for (const PlaneContact& contact : plane_contacts(assembly, material, half, planes, grain))
        forces.plane_contacts.push_back(contact);
  return forces;
}

GrainForces sum_on_grains(const ContactForces& forces, std::size_t grain_count) {
  GrainForces sums;
  sums.force.assign(grain_count, Vector3::Zero());
  sums.torque.assign(grain_count, Vector3::Zero());
  for (const Contact& contact : forces.contacts) {
    sums.force[contact.first] += contact.force.on_first;
    sums.force[contact.second] -= contact.force.on_first;
    sums.torque[contact.first] += contact.force.torque_on_first;
    sums.torque[contact.second] += contact.force.torque_on_second;
  }
  for (const PlaneContact& contact : forces.plane_contacts) sums.force[contact.grain] += contact.force_on_grain;
  return sums;
}

}  // namespace flowslide
