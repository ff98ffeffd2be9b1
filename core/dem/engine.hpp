// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <cstdint>
#include <memory>
#include <string>

#include "grains/assembly.hpp"
#include "grains/material.hpp"

namespace flowslide {

/// How the boundaries move from now on. Zero everywhere holds the cell still.
struct BoundaryMotion {
  /// Velocities of the two layers and, in their normal component, of the planes at z = lower and z = upper, m/s.
  Vector3 bottom_velocity = Vector3::Zero();
  Vector3 top_velocity = Vector3::Zero();
  /// Rates of compression of the cell along x and y about its centre, 1/s (positive = shortening). A rigid axis moves
  /// its two planes; a periodic axis carries all grains affinely, which does not enter their velocities.
  double compression_rate_x = 0.0;
  double compression_rate_y = 0.0;
};

/// Forces that the six boundaries exert on the mobile grains, N: the planes, and the glued layers with the z planes.
struct BoundaryForces {
  Vector3 bottom = Vector3::Zero(), top = Vector3::Zero();
  double x_lower = 0.0, x_upper = 0.0, y_lower = 0.0, y_upper = 0.0;  ///< normal components, along the axis
};

/// Stress on horizontal sections, averaged over the cell without a loop over pairs; compression positive, shear
/// positive when the top drags the sample towards +x (downslope).
struct SectionStress {
  double normal = 0.0;         ///< sigma = sigma_zz, Pa
  double shear = 0.0;          ///< tau = sigma_zx, Pa
  double transverse = 0.0;     ///< sigma_zy, Pa
};

/// Parameters that a run may change between two calls of `run`.
struct EngineSettings {
  Material material;
  double time_step = 5e-7;             ///< dt_L, s
  double drag = 0.0;                   ///< c of the force -c v on each mobile grain, kg/s (preparation only)
};

/// A discrete element method engine: Hertz normal force, tangential history with Coulomb cap, EPSD3 rolling, velocity
/// Verlet. One object simulates one assembly. All calls are collective over the ranks of MPI_COMM_WORLD and return the
/// same values on each. Errors are thrown as `EngineError`.
class Engine {
 public:
  virtual ~Engine() = default;

  /// Replaces what is simulated. The forces and histories of `assembly` are taken as they are: `load(save())` changes
  /// nothing that a later `run` computes, up to rounding.
  virtual void load(const Assembly& assembly, const EngineSettings& settings) = 0;
  /// The state at the end of the last step. Throws if a grain was lost.
  virtual Assembly save() const = 0;
  /// Changes parameters between steps.
  virtual void set(const EngineSettings& settings) = 0;
  virtual void move(const BoundaryMotion& motion) = 0;
  /// Advances `steps` >= 0 time steps.
  virtual void run(std::int64_t steps) = 0;

  /// Cost below one DEM step; of the end of the last step.
  virtual SectionStress section_stress() const = 0;
  virtual BoundaryForces boundary_forces() const = 0;
  virtual Cell cell() const = 0;
  virtual std::uint64_t count_grains() const = 0;

  virtual std::string name() const = 0;
  virtual std::string version() const = 0;
};

}  // namespace flowslide
