// SPDX-License-Identifier: GPL-2.0-or-later
#include "peers/first_forces.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

#include "grains/contact_forces.hpp"
#include "grains/contact_search.hpp"

namespace flowslide {
namespace {

double effective_mass(const PeerSample& sample, const TouchingPair& pair, const FirstStepLaw& law, double of_both) {
  if (!law.glued_are_heavy) return of_both;
  const Assembly& grains = sample.assembly;
  const auto mobile = [&](std::uint32_t i) { return grains.role[i] == Role::mobile; };
  if (mobile(pair.first) == mobile(pair.second)) return of_both;
  return sphere_mass(grains.radius[mobile(pair.first) ? pair.first : pair.second], sample.material);
}

/// The force on the first grain of a pair.
Vector3 pair_force(const PeerSample& sample, const TouchingPair& pair, const FirstStepLaw& law) {
  const Assembly& grains = sample.assembly;
  const auto [i, j] = pair;
  const Vector3 branch = grains.cell.nearest_image(grains.position[i] - grains.position[j]);
  const double distance = branch.norm(), overlap = grains.radius[i] + grains.radius[j] - distance;
  const Vector3 n = branch / distance;
  PairConstants constants = pair_constants(sample.material, grains.radius[i], grains.radius[j]);
  constants.effective_mass = effective_mass(sample, pair, law, constants.effective_mass);
  laws::ContactStiffness stiffness = contact_stiffness(sample.material, constants, overlap);
  const double factor = std::sqrt(constants.effective_radius * overlap) * constants.effective_mass;
  if (law.normal_rate > 0.0) stiffness.normal_damping = law.normal_rate * factor;
  if (law.tangential_rate > 0.0) stiffness.tangential_damping = law.tangential_rate * factor;

  const Vector3 velocity = grains.velocity[i] - grains.velocity[j];
  const double separation = velocity.dot(n), shorter = law.arms_to_surface ? 0.0 : 0.5 * overlap;
  const Vector3 surface_spin =
      (grains.radius[i] - shorter) * grains.spin[i] + (grains.radius[j] - shorter) * grains.spin[j];
  const Vector3 slip = velocity - separation * n - surface_spin.cross(n);
  double normal = stiffness.normal * overlap - stiffness.normal_damping * separation;
  if (law.attraction_left_out || sample.material.normal_force_limited) normal = std::max(0.0, normal);
  const Vector3 tangential = -stiffness.tangential_damping * slip;
  const double cap = sample.material.sliding_friction * std::abs(normal);
  const bool left_out = (law.none_beyond_cap && tangential.norm() > cap) || (law.attraction_left_out && cap == 0.0);
  return left_out ? Vector3(normal * n) : Vector3(normal * n + tangential);
}

}  // namespace

std::vector<Vector3> first_forces(const PeerSample& sample, const FirstStepLaw& law) {
  std::vector<Vector3> forces(sample.assembly.size(), Vector3::Zero());
  for (const TouchingPair& pair : touching_pairs(sample.assembly)) {
    const Vector3 force = pair_force(sample, pair, law);
    forces[pair.first] += force;
    forces[pair.second] -= force;
  }
  return forces;
}

std::vector<Vector3> first_forces_of_this_project(const PeerSample& sample) {
  Assembly without_springs = sample.assembly;
  without_springs.contacts.clear();
  ContactForces forces = evaluate_contact_forces(without_springs, sample.material, 0.0);
  forces.plane_contacts.clear();
  return sum_on_grains(forces, without_springs.size()).force;
}

SectionStress section_stress(const Assembly& assembly, const std::vector<Vector3>& forces) {
  Vector3 moment = Vector3::Zero(), on_top = Vector3::Zero();
  for (std::size_t i = 0; i < assembly.size(); ++i) {
    if (assembly.role[i] == Role::mobile) moment += (assembly.position[i].z() - assembly.cell.lower.z()) * forces[i];
    if (assembly.role[i] == Role::top_layer) on_top += forces[i];
  }
  const Vector3 row = (moment + assembly.cell.height() * on_top) / assembly.cell.volume();
  return {row.z(), -row.x()};
}

std::vector<Vector3> read_forces(const std::filesystem::path& file, std::size_t count) {
  std::ifstream stream(file);
  std::vector<Vector3> forces(count, Vector3::Zero());
  std::vector<bool> seen(count, false);
  std::size_t read = 0;
  for (std::string line; std::getline(stream, line);) {
    std::istringstream words(line);
    std::size_t id = 0;
    Vector3 force;
    std::string more;
    if (!(words >> id >> force.x() >> force.y() >> force.z()) || words >> more) continue;
    if (id < 1 || id > count || seen[id - 1])
      throw std::runtime_error(fmt::format("{}: grain {} is unknown or there twice", file.string(), id));
    seen[id - 1] = true;
    forces[id - 1] = force;
    ++read;
  }
  if (read != count)
    throw std::runtime_error(fmt::format("{}: forces of {} grains, expected {}", file.string(), read, count));
  return forces;
}

double force_error(const std::vector<Vector3>& forces, const std::vector<Vector3>& expected) {
  double error = 0.0, largest = 0.0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    error = std::max(error, (forces[i] - expected[i]).norm());
    largest = std::max(largest, expected[i].norm());
  }
  return error / largest;
}

}  // namespace flowslide
