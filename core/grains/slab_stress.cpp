// SPDX-License-Identifier: GPL-2.0-or-later
#include "grains/slab_stress.hpp"

#include <algorithm>

#include "grains/require.hpp"

namespace flowslide {
namespace {

/// Fraction of the interval between the heights `start` and `end` that is in the slab.
double share_inside(double start, double end, double lower, double upper) {
  const auto [low, high] = std::minmax(start, end);
  if (!(high > low)) return low >= lower && low < upper ? 1.0 : 0.0;
  return std::max(std::min(high, upper) - std::max(low, lower), 0.0) / (high - low);
}

}  // namespace

Matrix3 slab_stress(const Assembly& assembly, const ContactForces& forces, double lower, double upper) {
  require(lower < upper, "upper end of the slab", upper, "above its lower end", "exchange the two");
  const double height = assembly.cell.height();
  Matrix3 sum = Matrix3::Zero();
  for (const Contact& contact : forces.contacts) {
    const double start = assembly.position[contact.second].z();
    const double end = start + contact.branch.z();
    double share = share_inside(start, end, lower, upper);
    if (assembly.cell.periodic[2])  // a branch that leaves the cell at one face enters it at the other
      for (const double shift : {-height, height}) share += share_inside(start + shift, end + shift, lower, upper);
    sum += share * contact.branch * contact.force.on_first.transpose();
  }
  return sum / (assembly.cell.area() * (upper - lower));
}

Matrix3 bulk_stress(const Assembly& assembly, const ContactForces& forces) {
  const double margin = assembly.cell.periodic[2] ? 0.0 : assembly.mean_diameter();
  return slab_stress(assembly, forces, assembly.cell.lower.z() + margin, assembly.cell.upper.z() - margin);
}

}  // namespace flowslide
