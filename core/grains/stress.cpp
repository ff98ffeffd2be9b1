// SPDX-License-Identifier: GPL-2.0-or-later
#include "grains/stress.hpp"

namespace flowslide {
namespace {

/// sum l (x) f over the interior contacts.
Matrix3 interior_sum(const ContactForces& forces) {
  Matrix3 sum = Matrix3::Zero();
  for (const Contact& contact : forces.contacts) sum += contact.branch * contact.force.on_first.transpose();
  return sum;
}

/// Sum over both kinds of exterior contacts: mobile grains at planes, and glued grains at the plane behind them.
Matrix3 exterior_sum(const Assembly& assembly, const ContactForces& forces) {
  Matrix3 sum = Matrix3::Zero();
  for (const PlaneContact& contact : forces.plane_contacts)
    sum -= contact.point_from_grain * contact.force_on_grain.transpose();
  const GrainForces on_grains = sum_on_grains(forces, assembly.size());
  for (std::size_t i = 0; i < assembly.size(); ++i) {
    if (assembly.role[i] == Role::mobile) continue;
    const Cell& cell = assembly.cell;
    const double plane = assembly.role[i] == Role::top_layer ? cell.upper.z() : cell.lower.z();
    const Vector3 to_plane = Vector3::UnitZ() * (plane - assembly.position[i].z());
    const Vector3 force_of_glue = -on_grains.force[i];
    sum -= to_plane * force_of_glue.transpose();
  }
  return sum;
}

/// (alpha . epsilon)_ij = alpha_k epsilon_kij.
Matrix3 contract_with_levi_civita(const Vector3& a) {
  Matrix3 result;
  result << 0.0, a.z(), -a.y(),
      -a.z(), 0.0, a.x(),
      a.y(), -a.x(), 0.0;
  return result;
}

}  // namespace

Matrix3 bagi_stress(const Assembly& assembly, const ContactForces& forces) {
  return (interior_sum(forces) + exterior_sum(assembly, forces)) / assembly.cell.volume();
}

Matrix3 nicot_correction(const Assembly& assembly, const Material& material) {
  Matrix3 sum = Matrix3::Zero();
  for (std::size_t i = 0; i < assembly.size(); ++i) {
    if (assembly.role[i] != Role::mobile) continue;
    const double inertia = sphere_inertia(assembly.radius[i], material);
    const double chi = 0.5 * inertia;  // m R^2 / 5
    const Vector3& omega = assembly.spin[i];
    const Vector3 alpha = assembly.torque[i] / inertia;
    sum += chi * (contract_with_levi_civita(alpha) + omega * omega.transpose() -
                  omega.squaredNorm() * Matrix3::Identity());
  }
  return sum / assembly.cell.volume();
}

Matrix3 nicot_stress(const Assembly& assembly, const ContactForces& forces, const Material& material) {
  return bagi_stress(assembly, forces) + nicot_correction(assembly, material);
}

SlopeStress slope_stress(const Matrix3& stress) { return {stress(2, 2), -stress(2, 0), stress.trace() / 3.0}; }

}  // namespace flowslide
