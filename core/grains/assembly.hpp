// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "grains/cap.hpp"
#include "grains/vector.hpp"

namespace flowslide {

/// The rectangular cell of the grains. A rigid axis ends at two frictionless planes, at `lower` and `upper`.
struct Cell {
  Vector3 lower = Vector3::Zero();            ///< m
  Vector3 upper = Vector3::Zero();            ///< m
  std::array<bool, 3> periodic{false, false, false};
  /// For a cell that is periodic along z and sheared (A. W. Lees and S. F. Edwards, J. Phys. C 5 (1972) 1921-1929):
  /// shift of the image above along x, m, at most half a period either way. The image below is shifted by the opposite
  /// amount.
  double shear_offset = 0.0;
  /// Velocity of the image above along x relative to the cell, m/s: the shear rate times the height.
  double shear_velocity = 0.0;

  Vector3 lengths() const { return upper - lower; }
  double volume() const { return lengths().prod(); }
  /// Area of the horizontal section, m^2.
  double area() const { return lengths().x() * lengths().y(); }
  double height() const { return lengths().z(); }
  /// The nearest periodic image of `separation` (m).
  Vector3 nearest_image(Vector3 separation) const;
  /// For two grains with `separation` x_first - x_second (m): the velocity (m/s) of the image of the second grain that
  /// is nearest to the first, relative to the second grain itself.
  Vector3 nearest_image_velocity(const Vector3& separation) const;
};

/// A grain moves by Newton's law, or with one of the two layers glued to the bottom and the top of the cell.
enum class Role : std::uint8_t { mobile = 0, bottom_layer = 1, top_layer = 2 };

/// History of one touching pair, first < second; vectors are those of `first` relative to `second`.
struct ContactHistory {
  std::uint32_t first = 0, second = 0;        ///< indices into the assembly
  Vector3 tangential_spring = Vector3::Zero();  ///< m
  Vector3 rolling_torque = Vector3::Zero();     ///< N m
  /// Whether spring and torque are at their caps. Used only by evaluate_contact_forces: files do not store these
  /// members, and engines do not read them.
  Cap spring_cap = Cap::unknown, torque_cap = Cap::unknown;
};

/// The full state of a DEM run at the end of a step. All arrays per grain have shape (n). The index of a grain never
/// changes.
struct Assembly {
  Cell cell;
  std::vector<double> radius;                 ///< m
  std::vector<Vector3> position;              ///< m
  std::vector<Vector3> velocity;              ///< m/s, at the full step
  std::vector<Vector3> spin;                  ///< rad/s, at the full step
  std::vector<Vector3> force;                 ///< N, total force on each grain at the end of the last step
  std::vector<Vector3> torque;                ///< N m, likewise
  std::vector<Role> role;
  std::vector<ContactHistory> contacts;       ///< sorted by (first, second)

  std::size_t size() const { return radius.size(); }
  /// Sets the number of grains; new grains are mobile, at rest, at the origin, without force.
  void resize(std::size_t n);
  double solid_volume() const;                ///< m^3, overlaps not deducted
  double mean_diameter() const;               ///< m, number mean
  double smallest_radius() const;             ///< m
};

}  // namespace flowslide
