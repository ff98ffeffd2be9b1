// SPDX-License-Identifier: GPL-2.0-or-later
#include "peers/peer_sample.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <utility>
#include <vector>

#include "grains/contact_search.hpp"

namespace flowslide {

PeerSample with_layers_moving(PeerSample sample) {
  Assembly& grains = sample.assembly;
  for (std::size_t i = 0; i < grains.size(); ++i) {
    if (grains.role[i] == Role::mobile) continue;
    grains.velocity[i] = grains.spin[i] = Vector3::Zero();
    if (grains.role[i] == Role::top_layer) grains.velocity[i].x() = sample.top_velocity;
  }
  return sample;
}

TypicalContact typical_contact(const PeerSample& sample) {
  const Assembly& grains = sample.assembly;
  const Material& material = sample.material;
  std::vector<std::pair<double, PairConstants>> contacts;  // scale and constants
  for (const TouchingPair& pair : touching_pairs(grains)) {
    const double reach = grains.radius[pair.first] + grains.radius[pair.second];
    const double distance =
        grains.cell.nearest_image(grains.position[pair.first] - grains.position[pair.second]).norm();
    const PairConstants constants = pair_constants(material, grains.radius[pair.first], grains.radius[pair.second]);
    contacts.emplace_back(std::sqrt(constants.effective_radius * (reach - distance)), constants);
  }
  if (contacts.empty())
    throw std::invalid_argument("a sample for other codes has no contacts; prepare it under stress");
  const auto middle = contacts.begin() + static_cast<std::ptrdiff_t>(contacts.size() / 2);
  std::nth_element(contacts.begin(), middle, contacts.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  TypicalContact typical{middle->second, middle->first, {}, 0.0, 0.0};
  const double overlap = typical.scale * typical.scale / typical.pair.effective_radius;
  typical.stiffness = contact_stiffness(material, typical.pair, overlap);
  typical.rolling_stiffness = laws::Epsd3::stiffness(material, typical.pair, typical.stiffness.normal);
  typical.rolling_damping = laws::Epsd3::damping(material, typical.pair, typical.rolling_stiffness);
  return typical;
}

Vector3 position_in_cell(const Cell& cell, Vector3 position) {
  for (int axis = 0; axis < 3; ++axis) {
    if (!cell.periodic[axis]) continue;
    const double length = cell.lengths()[axis];
    position[axis] -= length * std::floor((position[axis] - cell.lower[axis]) / length);
    if (position[axis] >= cell.upper[axis]) position[axis] = cell.lower[axis];
  }
  return position;
}

std::string sample_table(const PeerSample& sample) {
  const Assembly& grains = sample.assembly;
  const Vector3& low = grains.cell.lower;
  const Vector3& high = grains.cell.upper;
  std::string text = fmt::format(
      "# {} grains; time step {:.17g} s; velocity of the top layer along x {:.17g} m/s\n"
      "# cell from {:.17g} {:.17g} {:.17g} to {:.17g} {:.17g} {:.17g} m, periodic in x and y\n"
      "# role radius x y z vx vy vz wx wy wz (SI; roles: 0 mobile, 1 bottom layer, 2 top layer)\n",
      grains.size(), sample.time_step, sample.top_velocity, low.x(), low.y(), low.z(), high.x(), high.y(), high.z());
  const auto add = [&](const Vector3& vector) {
    fmt::format_to(std::back_inserter(text), " {:.17g} {:.17g} {:.17g}", vector.x(), vector.y(), vector.z());
  };
  for (std::size_t i = 0; i < grains.size(); ++i) {
    fmt::format_to(std::back_inserter(text), "{} {:.17g}", static_cast<int>(grains.role[i]), grains.radius[i]);
    add(position_in_cell(grains.cell, grains.position[i]));
    add(grains.velocity[i]);
    add(grains.spin[i]);
    text += '\n';
  }
  return text;
}

}  // namespace flowslide
