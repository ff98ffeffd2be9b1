// SPDX-License-Identifier: GPL-2.0-or-later
#include "sample/stable_time_step.hpp"

#include <algorithm>
#include <limits>

#include "grains/measures.hpp"
#include "grains/time_step_share.hpp"

namespace flowslide {
namespace {

constexpr double reserve = 0.8;

/// Two equal grains of `radius` (m) at the largest overlap (m) of a head-on impact.
Assembly impact(double radius, double overlap) {
  Assembly pair;
  pair.resize(2);
  pair.radius = {radius, radius};
  pair.position[1].x() = 2.0 * radius - overlap;
  pair.cell.lower.setConstant(-10.0 * radius);
  pair.cell.upper.setConstant(10.0 * radius);
  return pair;
}

/// A stable time step of an assembly, s.
double stable(const Assembly& assembly, const Material& material, double time_step) {
  return time_step_below_edge(time_step, time_step_share(assembly, material, time_step));
}

double largest_velocity(const Assembly& assembly) {
  double largest = 0.0;
  for (const Vector3& velocity : assembly.velocity) largest = std::max(largest, velocity.norm());
  return largest;
}

}  // namespace

double time_step_for_impacts(double radius, const Material& material, double speed, double time_step) {
  if (speed == 0.0) return std::numeric_limits<double>::infinity();
  return stable(impact(radius, hertz_impact_overlap(radius, material, speed)), material, time_step);
}

double stable_time_step(const Assembly& assembly, const Material& material, double time_step) {
  const double of_impacts = time_step_for_impacts(assembly.smallest_radius(), material,
                                                  2.0 * largest_velocity(assembly), time_step);
  return reserve * std::min(stable(assembly, material, time_step), of_impacts);
}

}  // namespace flowslide
