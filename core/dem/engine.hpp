// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <cstdint>
#include <stdexcept>
#include <string>

#include "dem/drag_reference.hpp"
#include "grains/assembly.hpp"
#include "grains/material.hpp"

namespace flowslide {

/// An engine could not do what it was asked for. The message says what, where its log is, and how to mend it.
struct EngineError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// How the boundaries move from now on. Zero everywhere holds the cell still.
struct BoundaryMotion {
  /// Velocities of the two glued layers, m/s; their z components also move the planes behind them. In a cell that is
  /// periodic along z they are those of its faces: along x they shear it (see Cell::shear_velocity), and a change gives
  /// the grains that of the linear field (see NativeEngine); along z they carry all grains affinely, as periods do.
  Vector3 bottom_velocity = Vector3::Zero();
  Vector3 top_velocity = Vector3::Zero();
  /// Rates of compression of the cell along x and y about its centre, 1/s, positive when it becomes shorter. A rigid
  /// axis moves its two planes; a periodic axis carries all grains affinely, which does not enter their velocities.
  double compression_rate_x = 0.0;
  double compression_rate_y = 0.0;
};

/// Stress averaged over the cell, by contacts alone (no kinetic part, no drag), Pa. Compression is positive; shear is
/// positive when the top drags the sample towards +x, which is downslope.
struct CellStress {
  double normal = 0.0;      ///< sigma = sigma_zz
  double shear = 0.0;       ///< tau = sigma_zx
  double transverse = 0.0;  ///< sigma_zy
  double lateral_x = 0.0;   ///< sigma_xx
  double lateral_y = 0.0;   ///< sigma_yy

  /// p, the mean stress.
  double mean() const { return (normal + lateral_x + lateral_y) / 3.0; }
};

/// Parameters that may change between two calls of `run`.
struct EngineSettings {
  Material material;
  double time_step = 5e-7;  ///< dt_L, s
  double drag = 0.0;        ///< c of the force -c (v - u) on each mobile grain, kg/s; for preparation
  DragReference drag_reference = DragReference::rest;  ///< what u is

  static constexpr auto fields() {
    return std::tuple{Field{"material", &EngineSettings::material},
                      Field{"time_step", &EngineSettings::time_step, "s", Bounds::positive()},
                      Field{"drag", &EngineSettings::drag, "kg/s", Bounds::not_negative()},
                      Field{"drag_reference", &EngineSettings::drag_reference}};
  }
};
static_assert(lists_every_member<EngineSettings>());

/// A discrete element method engine: Hertz normal force, tangential history with Coulomb cap, EPSD3 rolling, velocity
/// Verlet, histories cleared when a contact opens. One object simulates one assembly. Every call is collective over
/// the ranks of MPI_COMM_WORLD and returns the same values on each of them. Failures are thrown as `EngineError`.
class Engine {
 public:
  virtual ~Engine() = default;

  /// Replaces what is simulated. Forces and histories are taken as they are, so that `load(save(), settings)` changes
  /// nothing that a later `run` computes, up to rounding. Until `move`, sheared faces slide on, all else stands still:
  /// a stress that is asked for before the next step takes the boundaries to have stood still in the last one.
  virtual void load(const Assembly& assembly, const EngineSettings& settings) = 0;
  /// The state at the end of the last step; positions along a periodic axis are folded into the cell.
  virtual Assembly save() const = 0;
  /// Changes parameters between steps.
  virtual void set(const EngineSettings& settings) = 0;
  virtual const EngineSettings& settings() const = 0;
  /// Sets the motion of the boundaries for the steps to come.
  virtual void move(const BoundaryMotion& motion) = 0;
  /// Advances `steps` >= 0 time steps of settings().time_step. `cell_stress` afterwards belongs to the last of them.
  virtual void run(std::int64_t steps) = 0;

  /// Stress at the end of the last step, at a cost below one step: no loop over pairs.
  virtual CellStress cell_stress() const = 0;
  virtual Cell cell() const = 0;
  /// Grains whose centre lies between the planes of every rigid axis.
  virtual std::uint64_t count_grains() const = 0;

  virtual std::string name() const = 0;
  /// Names the sources of the engine and its precision: equal versions of engines of one name give equal results.
  virtual std::string version() const = 0;
};

}  // namespace flowslide
