// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <array>
#include <vector>

#include "dem/engine.hpp"
#include "dem/native/contact_pass.hpp"

namespace flowslide::native {

/// Moves the cell and the glued layers, and adds what planes and drag do to the mobile grains.
class Boundaries {
 public:
  Boundaries(const Cell& cell, const EngineSettings& settings) : cell_(cell), settings_(settings) {}

  void set(const EngineSettings& settings) { settings_ = settings; }
  /// Takes the velocities of the layers into their grains.
  void move(const BoundaryMotion& motion, std::vector<Body>& bodies, const std::vector<Role>& role);
  /// Advances planes and periods by a step; a shrinking period carries all grains affinely.
  void advance(std::vector<Body>& bodies, std::size_t grains);
  /// Adds the forces of planes and drag to the loads of the mobile grains.
  void push(const std::vector<Body>& bodies, const std::vector<Role>& role, std::vector<Load>& loads);

  const Cell& cell() const { return cell_; }
  const BoundaryMotion& motion() const { return motion_; }
  /// Forces of the upper planes on the grains, each along its axis, N, of the last `push`.
  const Vector3& upper_plane() const { return upper_plane_; }
  /// Sums over mobile grains of z f (vector) and of x f_x, y f_y, z f_z of the drag forces, N m, of the last `push`.
  const Vector3& drag_height_times_force() const { return drag_height_times_force_; }
  const Vector3& drag_moment() const { return drag_moment_; }
  /// Bound on how fast two neighbours that follow the boundaries part or meet, m/s, if they are `reach` (m) apart.
  double mean_flow_speed(double reach) const;
  /// The boundaries' linear field of velocities.
  MeanFlow mean_flow() const;

 private:
  Cell cell_;
  EngineSettings settings_;
  BoundaryMotion motion_;
  Vector3 upper_plane_ = Vector3::Zero();
  Vector3 drag_height_times_force_ = Vector3::Zero(), drag_moment_ = Vector3::Zero();
};

}  // namespace flowslide::native
