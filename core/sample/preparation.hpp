// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <functional>
#include <optional>
#include <string>

#include "dem/engine.hpp"
#include "sample/recipe.hpp"

namespace flowslide {

/// A sample at rest under its initial stress, glued layers in place.
struct PreparedSample {
  Assembly assembly;
  CellStress stress;             ///< at rest, without drag
  double void_ratio = 0.0;       ///< e_0, of the whole cell
  double bulk_void_ratio = 0.0;  ///< without one mean diameter at the bottom and the top, if layers are glued there
  double kinetic_number = 0.0;   ///< mean kinetic energy of a grain over p D^3
  std::int64_t steps = 0;        ///< that the preparation took
};

/// All that a preparation goes on from, between two looks of its servo.
struct PreparationState {
  int stage = 1;                      ///< 0 is the mixing; 1 to 4; 5 is the last rest
  std::int64_t steps = 0;             ///< of this sample so far
  std::int64_t stage_start = 0;       ///< steps when the stage began
  std::int64_t within = 0;            ///< steps for which the stresses have been within their tolerance
  std::int64_t next_inspection = 0;   ///< steps at which the time step, and what is left of the lattice, are looked at
  CellStress stress;
  Assembly assembly;
};

/// Where a preparation stands.
struct PreparationProgress {
  int stage = 0;
  std::int64_t steps = 0;
  double void_ratio = 0.0;
  CellStress stress;
  std::function<PreparationState()> state;  ///< all of it; collective over the MPI ranks, as the engine is
};
using PreparationObserver = std::function<void(const PreparationProgress&)>;

/// A stage in words: "mixing", "stage 3 of 4", "rest".
std::string name_of_stage(int stage);

/// Prepares a sample in the four stages of the paper (sec. 2.2.1; refs 37, 38), after a stage 0 if the recipe has one:
/// (0) the grains of a sparse lattice packing fly about without drag between planes at rest, until there is no more of
/// the lattice in their positions than in random ones (see lattice_memory); (1) six rigid planes compress them at
/// constant rate until e = 1.2; (2) a servo brings it to 0.1 sigma_0; (3) the lateral planes become
/// periodic, 0.2 sigma_0; (4) a layer is glued to the bottom and the top, mu = 0.5, and the servo brings the normal
/// stresses to sigma_0 and the shear stress to tau_0. Stages 0 to 3 use mu_1. A viscous drag
/// acts in those stages that the recipe names: without it the collapsing gas stays agitated and always ends dense. The
/// sample then rests without it. What motion the mixing leaves goes on in stage 1. With
/// `periodic_height` the same stages run in a cell without planes and layers, sheared across its faces.
/// Leaves the sample loaded in `engine` with the settings of the recipe. Throws NumericalFailure if a stage does not
/// reach its target, or the sample does not hold its stress at rest.
/// `observe` is called after each look of the servo. With `from`, of the same recipe, it goes on from there: with the
/// same bits on an engine that loads what it has saved with all of them. Throws std::invalid_argument if `from` has
/// another number of grains.
PreparedSample prepare_sample(Engine& engine, const SampleRecipe& recipe, const PreparationObserver& observe = {},
                              const PreparationState* from = nullptr);

/// A hash of the sources of prepare_sample: equal versions prepare equal samples from equal recipes, on one engine.
std::string preparation_version();

}  // namespace flowslide
