// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <functional>
#include <optional>
#include <string>

#include "dem/engine.hpp"
#include "sample/recipe.hpp"

namespace flowslide {

/// A sample at rest under its initial stress, with its glued layers unless z is periodic.
struct PreparedSample {
  Assembly assembly;
  CellStress stress;             ///< at rest, without drag
  double void_ratio = 0.0;       ///< e_0, of the whole cell
  double probe_void_ratio = 0.0;  ///< see probe_void_ratio; that of the cell if no layer is glued
  double kinetic_number = 0.0;   ///< see kinetic_number in health.hpp, with p = sigma_0
  std::int64_t steps = 0;        ///< steps of the preparation
};

/// The state that a preparation continues from, between two updates of its servo. Steps count from its start.
struct PreparationState {
  int stage = 1;                      ///< 0: mixing; 1 to 4: see prepare_sample; 5: the final rest
  std::int64_t steps = 0;             ///< steps so far
  std::int64_t stage_start = 0;       ///< `steps` when the stage began
  std::int64_t within = 0;            ///< steps since the stresses have been within their tolerance
  std::int64_t next_inspection = 0;   ///< `steps` at the next check of the time step and, in stage 0, of the lattice
  CellStress stress;
  Assembly assembly;
};

/// Progress of a preparation.
struct PreparationProgress {
  int stage = 0;
  std::int64_t steps = 0;
  double void_ratio = 0.0;
  CellStress stress;
  std::function<PreparationState()> state;  ///< returns the full state; collective over the MPI ranks
};
using PreparationObserver = std::function<void(const PreparationProgress&)>;

/// Name of a stage: "mixing", "stage 3 of 4", "rest".
std::string name_of_stage(int stage);

/// Prepares a sample in the four stages of the paper (sec. 2.2.1; refs 37, 38), with an optional stage 0 before them:
///   0. Only if the recipe has a mixing velocity: the grains of a sparse lattice packing fly about without drag between
///      fixed planes until their positions have no more lattice order than random positions (see lattice_memory). Their
///      remaining motion continues in stage 1.
///   1. Six rigid planes compress the grains at a constant rate to `loose_void_ratio` (1.2).
///   2. A servo brings the normal stresses to 0.1 sigma_0.
///   3. The lateral planes become periodic, and the servo brings the normal stresses to 0.2 sigma_0.
///   4. One layer is glued to the bottom and one to the top, and the friction becomes that of the material (0.5). The
///      servo brings the normal stresses to sigma_0 and the shear stress to tau_0.
/// Stages 0 to 3 use the friction mu_1. A viscous drag acts in the stages that the recipe names. Without drag the
/// collapsing granular gas stays agitated and always ends dense. Finally the sample rests without drag.
/// With `periodic_height` the same stages run in a cell without planes and layers, sheared across its faces.
///
/// Leaves the sample loaded in `engine` with the settings of the recipe. Throws NumericalFailure if a stage does not
/// reach its target, or if the sample does not hold its stress at rest. Throws std::invalid_argument as `validate`.
///
/// `observe` is called after each servo interval. `from` is a state of the same recipe to continue from; the sample is
/// then the same bit for bit if the engine loads exactly what it has saved. Throws std::invalid_argument if `from` has
/// another number of grains.
PreparedSample prepare_sample(Engine& engine, const SampleRecipe& recipe, const PreparationObserver& observe = {},
                              const PreparationState* from = nullptr);

/// A hash of the sources of prepare_sample. On one engine, equal hashes prepare equal samples from equal recipes.
std::string preparation_version();

}  // namespace flowslide
