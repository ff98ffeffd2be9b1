// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <string>
#include <vector>

#include "grains/material.hpp"

namespace flowslide {

/// The material with each combination of torsion resistance and limit of the normal force.
inline std::vector<Material> with_all_switches(const Material& material) {
  std::vector<Material> all(4, material);
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i].torsion_resistance = i % 2 == 1;
    all[i].normal_force_limited = i / 2 == 1;
  }
  return all;
}

inline std::string switches_of(const Material& material) {
  return std::string("torsion ") + (material.torsion_resistance ? "on" : "off") + ", limit " +
         (material.normal_force_limited ? "on" : "off");
}

}  // namespace flowslide
