// SPDX-License-Identifier: GPL-2.0-or-later
#include "grains/kinetic_stress.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "grains/pair_constants.hpp"
#include "grains/require.hpp"

namespace flowslide {
namespace {

/// sum m v' (x) v' of the given grains, with v' relative to the straight line in z that fits their velocities best.
Matrix3 fluctuations(const Assembly& assembly, const Material& material, const std::vector<std::size_t>& grains) {
  double mass = 0.0, z_mean = 0.0, z_square = 0.0;
  Vector3 velocity_mean = Vector3::Zero(), slope = Vector3::Zero();
  for (const std::size_t i : grains) {
    const double m = sphere_mass(assembly.radius[i], material);
    mass += m;
    z_mean += m * assembly.position[i].z();
    velocity_mean += m * assembly.velocity[i];
  }
  z_mean /= mass;
  velocity_mean /= mass;
  for (const std::size_t i : grains) {
    const double m = sphere_mass(assembly.radius[i], material);
    const double z = assembly.position[i].z() - z_mean;
    z_square += m * z * z;
    slope += m * z * (assembly.velocity[i] - velocity_mean);
  }
  slope = grains.size() >= 3 && z_square > 0.0 ? Vector3(slope / z_square) : Vector3::Zero();
  Matrix3 sum = Matrix3::Zero();
  for (const std::size_t i : grains) {
    const Vector3 v = assembly.velocity[i] - velocity_mean - slope * (assembly.position[i].z() - z_mean);
    sum += sphere_mass(assembly.radius[i], material) * v * v.transpose();
  }
  return sum;
}

}  // namespace

Matrix3 kinetic_stress(const Assembly& assembly, const Material& material, int sublayers) {
  require(sublayers >= 1, "number of sublayers", sublayers, ">= 1", "Use 10, as Fig. 10 does.");
  std::vector<std::vector<std::size_t>> members(sublayers);
  for (std::size_t i = 0; i < assembly.size(); ++i) {
    if (assembly.role[i] != Role::mobile) continue;
    const double fraction = (assembly.position[i].z() - assembly.cell.lower.z()) / assembly.cell.height();
    members[static_cast<std::size_t>(std::clamp(std::floor(fraction * sublayers), 0.0, sublayers - 1.0))].push_back(i);
  }
  Matrix3 sum = Matrix3::Zero();
  for (const auto& grains : members)
    if (!grains.empty()) sum += fluctuations(assembly, material, grains);
  return sum / assembly.cell.volume();
}

}  // namespace flowslide
