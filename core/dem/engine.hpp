// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <cstdint>
#include <stdexcept>
#include <string>

#include "dem/drag_reference.hpp"
#include "grains/assembly.hpp"
#include "grains/cell_stress.hpp"
#include "grains/material.hpp"

namespace flowslide {

/// An engine failed. The message gives the failure, the log file if there is one, and the remedy.
struct EngineError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Motion of the boundaries in the following steps. If all members are 0, the cell stands still.
struct BoundaryMotion {
  /// Velocities of the two glued layers, m/s. Their z components also move the planes behind the layers. In a cell that
  /// is periodic along z they are the velocities of its faces. Along x they shear the cell (see Cell::shear_velocity);
  /// a change of the shear rate adds the change of the linear velocity field to the grains (see NativeEngine). Along z
  /// they move all grains affinely, as the compression of a periodic axis does.
  Vector3 bottom_velocity = Vector3::Zero();
  Vector3 top_velocity = Vector3::Zero();
  /// Compression rates of the cell along x and y about its centre, 1/s, positive when the cell becomes shorter. On a
  /// rigid axis the two planes move. On a periodic axis all grains move affinely; their velocities do not include this
  /// motion.
  double compression_rate_x = 0.0;
  double compression_rate_y = 0.0;
};

/// Parameters that may change between two calls of `run`.
struct EngineSettings {
  Material material;
  double time_step = 5e-7;  ///< dt_L, s
  double drag = 0.0;        ///< c of the drag force -c (v - u) on each mobile grain, kg/s; for the preparation
  DragReference drag_reference = DragReference::rest;  ///< the velocity u

  static constexpr auto fields() {
    return std::tuple{Field{"material", &EngineSettings::material},
                      Field{"time_step", &EngineSettings::time_step, "s", Bounds::positive()},
                      Field{"drag", &EngineSettings::drag, "kg/s", Bounds::not_negative()},
                      Field{"drag_reference", &EngineSettings::drag_reference}};
  }
};
static_assert(lists_every_member<EngineSettings>());

/// An engine of the discrete element method with velocity Verlet and the contact law that the material names (see
/// grains/laws/contact_laws.hpp). The history of a contact is cleared when it opens. One object simulates one assembly,
/// and any number of objects may live side by side. Every call is collective over the ranks of the communicator that
/// the engine was given, and returns the same values on all of them. Failures throw EngineError.
class Engine {
 public:
  virtual ~Engine() = default;

  /// Replaces the simulated assembly, with its forces and histories: `load(save(), settings)` changes no later result
  /// of `run`, except by rounding. Until `move` is called, sheared faces keep their velocity, and all other boundaries
  /// stand still. A stress that is read before the next step assumes boundaries at rest in the last step.
  virtual void load(const Assembly& assembly, const EngineSettings& settings) = 0;
  /// The state at the end of the last step. Positions along a periodic axis are folded into the cell.
  virtual Assembly save() const = 0;
  /// Changes parameters between two steps.
  virtual void set(const EngineSettings& settings) = 0;
  virtual const EngineSettings& settings() const = 0;
  /// Sets the motion of the boundaries in the following steps.
  virtual void move(const BoundaryMotion& motion) = 0;
  /// Makes `steps` (>= 0) time steps of settings().time_step. `cell_stress` then gives the stress of the last step.
  virtual void run(std::int64_t steps) = 0;

  /// Stress at the end of the last step. It needs no loop over pairs and costs less than a step.
  virtual CellStress cell_stress() const = 0;
  virtual Cell cell() const = 0;
  /// Number of grains whose centre is between the planes of every rigid axis.
  virtual std::uint64_t count_grains() const = 0;

  virtual std::string name() const = 0;
  /// Identifies the sources and the precision of the engine. Engines of equal name and version give equal results.
  virtual std::string version() const = 0;
};

}  // namespace flowslide
