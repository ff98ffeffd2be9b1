// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <fix.h>

#include <array>

#include "dem/engine.hpp"

namespace flowslide {

/// Moves the boundaries inside LIGGGHTS' own step, so that nothing has to be set up again between two calls of `run`:
/// glued layers, planes, a cell that becomes shorter, and the drag of preparation. Planes are frictionless and elastic
/// with the grains' own dashpot.
class SteeringFix : public LAMMPS_NS::Fix {
 public:
  SteeringFix(LAMMPS_NS::LAMMPS* lammps, const Cell& cell, const EngineSettings& settings);

  int setmask() override;
  void initial_integrate(int) override;
  void setup(int) override { post_force(0); }
  void post_force(int) override;

  void move(const BoundaryMotion& motion);
  void set(const EngineSettings& settings) { settings_ = settings; }
  const Cell& cell() const { return cell_; }

  /// Sums over the grains of this rank, of the last evaluation of forces, drag left out: N m, N.
  struct Sums {
    Vector3 mobile_height_times_force = Vector3::Zero();  ///< sum of z f, z from the bottom plane
    Vector3 top_force = Vector3::Zero();                  ///< of the top layer and its plane on mobile grains
    Vector3 mobile_moment = Vector3::Zero();              ///< sums of x f_x, y f_y, z f_z from the lower planes
    Vector3 upper_plane = Vector3::Zero();                ///< forces of the upper planes, each along its axis
    std::uint64_t grains = 0;                             ///< with the centre inside the planes
  };
  Sums sums() const;

 private:
  void carry_layers(double step);
  void compress(double step);
  void push_from_planes();
  void drag_grains();

  Cell cell_;
  EngineSettings settings_;
  BoundaryMotion motion_;
  Vector3 upper_plane_ = Vector3::Zero();
  Vector3 drag_height_times_force_ = Vector3::Zero(), drag_moment_ = Vector3::Zero();
};

}  // namespace flowslide
