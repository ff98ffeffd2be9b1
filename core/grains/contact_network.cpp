// SPDX-License-Identifier: GPL-2.0-or-later
#include "grains/contact_network.hpp"

#include <algorithm>
#include <cmath>

#include "grains/contact_search.hpp"

namespace flowslide {
namespace {

constexpr std::size_t most_contacts_of_rattler = 1;

double anisotropy(const Assembly& assembly, const std::vector<TouchingPair>& pairs) {
  Matrix3 fabric = Matrix3::Zero();
  double contacts = 0.0;
  for (const TouchingPair& pair : pairs) {
    if (assembly.role[pair.first] != Role::mobile && assembly.role[pair.second] != Role::mobile) continue;
    const Vector3 normal =
        assembly.cell.nearest_image(assembly.position[pair.first] - assembly.position[pair.second]).normalized();
    fabric += normal * normal.transpose();
    contacts += 1.0;
  }
  if (contacts == 0.0) return 0.0;
  const Matrix3 deviator = fabric / contacts - Matrix3::Identity() / 3.0;
  return std::sqrt(1.5 * deviator.squaredNorm());
}

}  // namespace

ContactNetwork contact_network(const Assembly& assembly) {
  const std::vector<TouchingPair> pairs = touching_pairs(assembly);
  std::vector<std::size_t> contacts(assembly.size(), 0);
  for (const TouchingPair& pair : pairs) {
    ++contacts[pair.first];
    ++contacts[pair.second];
  }
  ContactNetwork network;
  double mobile = 0.0, rattlers = 0.0, ends = 0.0, carried = 0.0;
  for (std::size_t i = 0; i < assembly.size(); ++i) {
    if (assembly.role[i] != Role::mobile) continue;
    const auto number = static_cast<double>(contacts[i]);
    network.shares.resize(std::max(network.shares.size(), contacts[i] + 1), 0.0);
    network.shares[contacts[i]] += 1.0;
    mobile += 1.0;
    ends += number;
    if (contacts[i] > most_contacts_of_rattler)
      carried += number;
    else
      rattlers += 1.0;
  }
  if (mobile == 0.0) return network;
  for (double& share : network.shares) share /= mobile;
  network.coordination_number = ends / mobile;
  if (mobile > rattlers) network.mechanical_coordination_number = carried / (mobile - rattlers);
  network.rattler_share = rattlers / mobile;
  network.fabric_anisotropy = anisotropy(assembly, pairs);
  return network;
}

}  // namespace flowslide
