// SPDX-License-Identifier: GPL-2.0-or-later
#include "scene_context.hpp"

#include <fmt/format.h>

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

/// The recipe that the table [sample.<name>] sets.
SampleRecipe& recipe_named(SceneSettings& settings, const Configuration& configuration, const std::string& name) {
  if (name == "loose") return settings.loose;
  if (name == "dense") return settings.dense;
  configuration.refuse("sample." + name, "is not a sample of these scenes", "remove it, or name it loose or dense");
}

/// Throws ConfigurationError unless both samples are there. recipe_named refuses any other sample.
void require_samples(const Configuration& configuration) {
  for (const char* name : {"loose", "dense"})
    if (!configuration.has(std::string("sample.") + name))
      configuration.refuse(std::string("sample.") + name, "is missing", "add the table of that sample");
}

}  // namespace

SceneSettings SceneSettings::read(const Configuration& configuration) {
  SceneSettings settings;
  settings.engine = configuration.text("engine", engine_names());
  settings.seed = configuration.integer("seed", Range::between(0, 1e9));
  configuration.accept("replicates");
  configuration.accept("preparation.engine");
  settings.slope = read_slope(configuration);
  settings.material = read_material(configuration);
  check_strength(configuration, settings.slope, settings.material.sliding_friction);
  require_samples(configuration);
  for (const SampleSpecification& sample : read_samples(configuration, settings.slope, 0)) {
    recipe_named(settings, configuration, sample.name) = sample.recipe;
    settings.allow_uneven = sample.allow_uneven;
  }
  read_coupling(configuration, "coupling", settings.slope, grain_scale(settings.loose));
  settings.inputs = loading_inputs(configuration, "loading", read_loading(configuration, "loading"));
  settings.seeds = configuration.integer("suite.seeds", Range::between(1, 100));
  settings.shear_rate = configuration.quantity("suite.shear_rate", dimension::rate, Range::positive());
  settings.rest_steps = configuration.integer("suite.rest_steps", Range::between(1000, 1e12));
  if (configuration.has("suite.large_lattice")) {
    const auto counts = configuration.integers("suite.large_lattice", Range::between(3, 1000));
    if (counts.size() != 3)
      configuration.refuse("suite.large_lattice", fmt::format("has {} counts, but a lattice has 3", counts.size()),
                           "write it as [41, 41, 42]");
    for (std::size_t axis = 0; axis < 3; ++axis) settings.large_lattice[axis] = static_cast<int>(counts[axis]);
  }
  settings.configuration = configuration;  // a copy at this stage knows all keys read above
  return settings;
}

SampleRecipe SceneContext::numbered(SampleRecipe recipe, std::int64_t sample) {
  recipe.packing.seed += static_cast<std::uint64_t>(sample) * seeds_per_sample;
  return recipe;
}

PreparedSample SceneContext::prepared(const SampleRecipe& recipe) const {
  const auto preparing = engine();
  return find_sample(*preparing, {"of a hard scene", recipe, any_void_ratio, settings_.allow_uneven},
                     sample_cache_folder(), run_.progress,
                     [this](const auto& keep) { run_.checkpoints.poll_in_preparation(keep); })
      .sample;
}

std::unique_ptr<Engine> SceneContext::engine() const {
  return make_engine(settings_.engine, run_.output.file(run_.provenance.point + "." + settings_.engine + ".log"),
                     run_.threads, all_ranks());
}

SlideSettings SceneContext::slide(const std::string& coupling, const std::string& loading,
                                  const SlopeProperties& slope) const {
  const Configuration trial = settings_.configuration->overlaid(
      "[trial.coupling]\n" + coupling + "\n[trial.loading]\n" + loading + "\n", "trial");
  SlideSettings settings = read_coupling(trial, {"trial.coupling", "coupling"}, slope, grain_scale(settings_.loose));
  settings.loading = read_loading(trial, {"trial.loading", "loading"});
  return settings;
}

}  // namespace flowslide
