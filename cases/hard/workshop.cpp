// SPDX-License-Identifier: GPL-2.0-or-later
#include "workshop.hpp"

#include "dem/make_engine.hpp"
#include "grains/packing.hpp"
#include "input/read_coupling.hpp"
#include "input/read_samples.hpp"
#include "process/mpi_session.hpp"
#include "sample_library/sample_cache.hpp"

namespace flowslide {
namespace {

/// Distance between the seeds of two samples. It leaves room for packings that collapse.
constexpr std::uint64_t seeds_per_sample = 1000;
/// A range so wide that the search accepts the first sample that comes to rest.
constexpr VoidRatioTarget any_void_ratio{0.775, 0.22, 10};

GrainScale grain_scale(const SampleRecipe& recipe) {
  return {lattice_packing(recipe.packing).mean_diameter(), recipe.material.density};
}

/// The recipe of the suite that the table [sample.<name>] sets.
SampleRecipe& recipe_named(Suite& suite, const Configuration& configuration, const std::string& name) {
  if (name == "loose") return suite.loose;
  if (name == "dense") return suite.dense;
  configuration.refuse("sample." + name, "is not a sample of these scenes", "remove it, or name it loose or dense");
}

/// Throws ConfigurationError unless both samples are there. recipe_named refuses any other sample.
void require_samples(const Configuration& configuration) {
  for (const char* name : {"loose", "dense"})
    if (!configuration.has(std::string("sample.") + name))
      configuration.refuse(std::string("sample.") + name, "is missing", "add the table of that sample");
}

}  // namespace

Suite Suite::read(const Configuration& configuration) {
  Suite suite;
  suite.engine = configuration.text("engine", engine_names());
  suite.seed = configuration.integer("seed", Range::between(0, 1e9));
  configuration.accept("replicates");
  configuration.accept("preparation.engine");
  suite.slope = read_slope(configuration);
  suite.material = read_material(configuration);
  check_strength(configuration, suite.slope, suite.material.sliding_friction);
  require_samples(configuration);
  for (const SampleSpecification& sample : read_samples(configuration, suite.slope, 0)) {
    recipe_named(suite, configuration, sample.name) = sample.recipe;
    suite.allow_uneven = sample.allow_uneven;
  }
  read_coupling(configuration, "coupling", suite.slope, grain_scale(suite.loose));
  suite.inputs = loading_inputs(configuration, "loading", read_loading(configuration, "loading"));
  suite.seeds = configuration.integer("suite.seeds", Range::between(1, 100));
  suite.shear_rate = configuration.quantity("suite.shear_rate", dimension::rate, Range::positive());
  suite.rest_steps = configuration.integer("suite.rest_steps", Range::between(1000, 1e12));
  if (configuration.has("suite.large_lattice")) {
    const auto counts = configuration.integers("suite.large_lattice", Range::between(3, 1000));
    if (counts.size() != 3)
      configuration.refuse("suite.large_lattice", "a lattice has three counts", "write it as [41, 41, 42]");
    for (std::size_t axis = 0; axis < 3; ++axis) suite.large_lattice[axis] = static_cast<int>(counts[axis]);
  }
  suite.configuration = configuration;  // a copy at this stage knows all keys read above
  return suite;
}

SampleRecipe Workshop::numbered(SampleRecipe recipe, std::int64_t sample) {
  recipe.packing.seed += static_cast<std::uint64_t>(sample) * seeds_per_sample;
  return recipe;
}

PreparedSample Workshop::prepared(const SampleRecipe& recipe) const {
  const auto preparing = engine();
  return find_sample(*preparing, {"of a hard scene", recipe, any_void_ratio, suite_.allow_uneven},
                     sample_cache_folder(), run_.progress,
                     [this](const auto& keep) { run_.checkpoints.border_of_preparation(keep); })
      .sample;
}

std::unique_ptr<Engine> Workshop::engine() const {
  return make_engine(suite_.engine, run_.output.file(run_.provenance.point + "." + suite_.engine + ".log"),
                     run_.threads, all_ranks());
}

SlideSettings Workshop::slide(const std::string& coupling, const std::string& loading,
                              const SlopeProperties& slope) const {
  const Configuration trial =
      suite_.configuration->overlaid("[trial.coupling]\n" + coupling + "\n[trial.loading]\n" + loading + "\n", "trial");
  SlideSettings settings = read_coupling(trial, {"trial.coupling", "coupling"}, slope, grain_scale(suite_.loose));
  settings.loading = read_loading(trial, {"trial.loading", "loading"});
  return settings;
}

}  // namespace flowslide
