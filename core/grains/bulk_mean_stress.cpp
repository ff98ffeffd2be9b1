// SPDX-License-Identifier: GPL-2.0-or-later
#include "grains/bulk_mean_stress.hpp"

#include <algorithm>

#include "grains/kinetic_stress.hpp"
#include "grains/slab_stress.hpp"
#include "grains/stress.hpp"

namespace flowslide {

double bulk_mean_stress(const Assembly& assembly, const ContactForces& forces, const Material& material) {
  const double contacts = slope_stress(bulk_stress(assembly, forces)).mean;
  return std::max(contacts, 0.0) + slope_stress(kinetic_stress(assembly, material)).mean;
}

}  // namespace flowslide
