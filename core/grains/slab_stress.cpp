// SPDX-License-Identifier: GPL-2.0-or-later
#include "grains/slab_stress.hpp"

#include <algorithm>

#include "grains/require.hpp"

namespace flowslide {

Matrix3 slab_stress(const Assembly& assembly, const ContactForces& forces, double lower, double upper) {
  require(lower < upper, "upper end of the slab", upper, "above its lower end", "exchange the two");
  Matrix3 sum = Matrix3::Zero();
  for (const Contact& contact : forces.contacts) {
    const double start = assembly.position[contact.second].z();
    const double end = start + contact.branch.z();
    const auto [low, high] = std::minmax(start, end);
    const double inside = std::min(high, upper) - std::max(low, lower);
    double share = 0.0;
    if (high > low)
      share = std::max(inside, 0.0) / (high - low);
    else
      share = low >= lower && low < upper ? 1.0 : 0.0;
    sum += share * contact.branch * contact.force.on_first.transpose();
  }
  return sum / (assembly.cell.area() * (upper - lower));
}

Matrix3 bulk_stress(const Assembly& assembly, const ContactForces& forces) {
  const double margin = assembly.mean_diameter();
  return slab_stress(assembly, forces, assembly.cell.lower.z() + margin, assembly.cell.upper.z() - margin);
}

}  // namespace flowslide
