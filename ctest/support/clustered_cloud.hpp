// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <cmath>
#include <cstdint>
#include <random>

#include "grains/assembly.hpp"
#include "grains/contact_search.hpp"

namespace flowslide {

/// What a cloud is made of.
struct CloudShape {
  std::size_t grains = 100;
  double smallest = 2.5e-3, largest = 3.5e-3;  ///< radii, m
  double overlap = 0.02;                       ///< largest overlap as a share of the sum of two radii
  double speed = 0.1, spin = 30.0;             ///< largest component of velocity, m/s, and of spin, rad/s
  double spring = 1e-8, torque = 1e-8;         ///< largest component of the histories, m and N m
};

/// Random numbers that are the same with every standard library.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : engine_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1.0p-53;
  }
  Vector3 vector(double largest) {
    const double x = between(-largest, largest), y = between(-largest, largest);
    return {x, y, between(-largest, largest)};
  }
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(engine_() % n); }

 private:
  std::mt19937_64 engine_;
};

/// True if a grain at `position` overlaps no grain by more than `share` of the radii and keeps off rigid planes.
inline bool fits(const Assembly& cloud, std::size_t count, const Vector3& position, double radius, double share) {
  for (int axis = 0; axis < 3; ++axis)
    if (!cloud.cell.periodic[axis] && (position[axis] < cloud.cell.lower[axis] + 0.99 * radius ||
                                       position[axis] > cloud.cell.upper[axis] - 0.99 * radius))
      return false;
  for (std::size_t j = 0; j < count; ++j) {
    const double reach = (1.0 - share) * (radius + cloud.radius[j]);
    if (cloud.cell.nearest_image(position - cloud.position[j]).norm() < reach) return false;
  }
  return true;
}

/// A cloud of mobile grains in `cell` in which each is placed, where possible, in touch with an earlier one, with
/// random velocities, spins and histories and without forces. Positions are in the cell.
inline Assembly clustered_cloud(std::uint64_t seed, const Cell& cell, const CloudShape& shape = {}) {
  Dice dice(seed);
  Assembly cloud;
  cloud.cell = cell;
  cloud.resize(shape.grains);
  std::size_t count = 0;
  for (int attempt = 0; count < shape.grains && attempt < 400 * static_cast<int>(shape.grains); ++attempt) {
    const double radius = dice.between(shape.smallest, shape.largest);
    Vector3 position =
        cell.lower + Vector3(dice.between(0, 1), dice.between(0, 1), dice.between(0, 1)).cwiseProduct(cell.lengths());
    if (count > 0 && attempt % 8 != 0) {
      const std::size_t near = dice.below(count);
      position = cloud.position[near] + dice.vector(1.0).normalized() * (radius + cloud.radius[near]) *
                                            (1.0 - dice.between(-0.2, 1.0) * shape.overlap);
      for (int axis = 0; axis < 3; ++axis)
        if (cell.periodic[axis])
          position[axis] -=
              cell.lengths()[axis] * std::floor((position[axis] - cell.lower[axis]) / cell.lengths()[axis]);
    }
    if (!fits(cloud, count, position, radius, shape.overlap)) continue;
    cloud.radius[count] = radius;
    cloud.position[count++] = position;
  }
  cloud.radius.resize(count);
  for (auto* array : {&cloud.position, &cloud.velocity, &cloud.spin, &cloud.force, &cloud.torque}) array->resize(count);
  cloud.role.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    cloud.velocity[i] = dice.vector(shape.speed);
    cloud.spin[i] = dice.vector(shape.spin);
  }
  for (const TouchingPair& pair : touching_pairs(cloud))
    cloud.contacts.push_back({pair.first, pair.second, dice.vector(shape.spring), dice.vector(shape.torque)});
  return cloud;
}

/// A cube of `length` (m) about the origin.
inline Cell cube(double length, bool periodic) {
  Cell cell;
  cell.lower.setConstant(-0.5 * length);
  cell.upper.setConstant(0.5 * length);
  cell.periodic = {periodic, periodic, periodic};
  return cell;
}

}  // namespace flowslide
