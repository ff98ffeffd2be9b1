// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <fix.h>

#include <array>

#include "dem/engine.hpp"
#include "dem/stress_sums.hpp"

namespace flowslide {

/// Moves the boundaries within the time step of LIGGGHTS, so that `run` needs no new set-up: glued layers, planes and
/// the lateral lengths of the cell. It also applies the drag of the preparation. Planes are frictionless and have the
/// Hertz force and the dashpot of the grains.
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

  /// Sums over the grains of this rank at the last evaluation of forces, without the virials of pairs.
  StressSums sums() const;
  /// Number of grains of this rank whose centre is between the planes.
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
