// SPDX-License-Identifier: GPL-2.0-or-later
#include "grains/assembly.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace flowslide {

Vector3 Cell::nearest_image(Vector3 separation) const {
  const Vector3 length = lengths();
  if (shear_offset != 0.0) separation.x() -= shear_offset * std::round(separation.z() / length.z());
  for (int axis = 0; axis < 3; ++axis)
    if (periodic[axis]) separation[axis] -= length[axis] * std::round(separation[axis] / length[axis]);
  return separation;
}

Vector3 Cell::nearest_image_velocity(const Vector3& separation) const {
  if (shear_velocity == 0.0) return Vector3::Zero();
  return std::round(separation.z() / height()) * shear_velocity * Vector3::UnitX();
}

void Assembly::resize(std::size_t n) {
  radius.resize(n, 0.0);
  for (auto* array : {&position, &velocity, &spin, &force, &torque}) array->resize(n, Vector3::Zero());
  role.resize(n, Role::mobile);
}

double Assembly::solid_volume() const {
  return std::accumulate(radius.begin(), radius.end(), 0.0, [](double sum, double r) {
    return sum + 4.0 / 3.0 * std::numbers::pi * r * r * r;
  });
}

double Assembly::mean_diameter() const {
  return 2.0 * std::accumulate(radius.begin(), radius.end(), 0.0) / static_cast<double>(size());
}

double Assembly::smallest_radius() const { return *std::min_element(radius.begin(), radius.end()); }

}  // namespace flowslide
