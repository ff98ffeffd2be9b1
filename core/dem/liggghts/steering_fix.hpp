// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <fix.h>

#include <array>

#include "dem/engine.hpp"
#include "dem/stress_sums.hpp"

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

  /// Sums over the grains of this rank, of the last evaluation of forces; the virials of pairs are not among them.
  StressSums sums() const;
  /// Grains of this rank with their centre inside the planes.
  std::uint64_t grains_inside() const;

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
