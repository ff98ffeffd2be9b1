// SPDX-License-Identifier: GPL-2.0-or-later
// Fast shear, and grains whose sizes, contact parameters or number differ from those of the paper.
#include <fmt/format.h>

#include <cmath>

#include "experiments.hpp"
#include "scenes.hpp"

namespace flowslide {
namespace {

constexpr int peak_readings = 200;
constexpr double peak_strain = 0.006;  // up to this strain, trajectories have not diverged by rounding

/// Adds two trials: the largest shear stress of a sample at time steps of 0.2 and 0.45 Rayleigh times. The right value
/// is that at 0.1 Rayleigh times.
void add_peak(const SceneContext& context, SampleRecipe recipe, const std::string& setting, const std::string& refusal,
              SceneRecord& record) {
  double right = 0.0;
  Assembly sample;
  const auto peak = [&](double share) {
    const double step = time_step_of(share, sample, recipe.material);
    const Shearing shearing{context.settings().shear_rate, peak_strain, peak_readings};
    return peak_of(shear(context, sample, {recipe.material, step}, shearing));
  };
  const SceneTrial preparation = attempt(setting + ", prepared: e_0", {0.75, 0.15, 0.5, 1.0, refusal}, [&] {
    const PreparedSample prepared = context.prepared(recipe);
    sample = prepared.assembly;
    right = peak(0.1);
    return prepared.void_ratio;
  });
  record.trials.push_back(preparation);
  if (preparation.outcome == Outcome::refused || preparation.outcome == Outcome::needless) return;
  for (const double share : {0.2, 0.45})
    record.trials.push_back(attempt(fmt::format("{}, dt_L = {} t_R: largest tau, Pa", setting, share),
                                    relative(right, 0.02, 0.1, share > 0.4 ? "too long for contacts" : ""),
                                    [&] { return peak(share); }));
}

}  // namespace

SceneRecord fast_shear_scene(const SceneContext& context) {
  const Material& material = context.settings().material;
  const Assembly sample = expanded(context, 0.125);
  const auto stress = [&](double rate, double step) {
    return mean_shear(shear(context, sample, {material, step}, {rate, 20.0, 2000}), 5.0);
  };
  SceneRecord record;
  double before = 0.0, slower = 0.0;
  for (const double rate : {100.0, 300.0, 1000.0}) {
    // At constant volume, stresses of rigid grains grow with the square of the rate (Bagnold 1954); soft grains less.
    const double growth = before > 0.0 ? before * std::pow(rate / slower, 2) : 0.0;
    double right = 0.0;
    const SceneTrial refined = attempt(fmt::format("{} /s, dt_L = 2e-06 s, by the square of the rate, Pa", rate),
                                       {growth, 0.3 * growth, 0.2 * growth, 1.5 * growth, "overlap"},
                                       [&] { return right = stress(rate, 2e-6); });
    if (growth > 0.0 || right == 0.0) record.trials.push_back(refined);
    if (right == 0.0) continue;  // refused
    before = right;
    slower = rate;
    for (const double step : {1e-6, 5e-6, 1e-5})
      record.trials.push_back(attempt(fmt::format("{} /s, dt_L = {:.0e} s, Pa", rate, step),
                                      relative(right, 0.15, 0.4, rate * step > 3e-4 ? "time step" : ""),
                                      [&] { return stress(rate, step); }));
  }
  return record;
}

SceneRecord size_scene(const SceneContext& context) {
  SceneRecord record;
  SampleRecipe recipe = context.settings().loose;
  recipe.packing.smallest_diameter = 3e-3;
  recipe.packing.largest_diameter = 9e-3;
  recipe.time_step = 5e-6;
  add_peak(context, recipe, "size ratio 1:3", "", record);
  recipe = context.settings().loose;
  recipe.packing.counts = {5, 5, 4};
  add_peak(context, recipe, "100 grains", "", record);
  recipe.packing.counts = {3, 3, 3};
  add_peak(context, recipe, "27 grains", "", record);
  return record;
}

SceneRecord material_scene(const SceneContext& context) {
  SceneRecord record;
  for (const double restitution : {0.1, 0.5, 1.0}) {
    SampleRecipe recipe = context.settings().loose;
    recipe.material.restitution = restitution;
    recipe.time_step = 4e-6;
    add_peak(context, recipe, fmt::format("restitution {}", restitution), restitution == 1.0 ? "preparation" : "",
             record);
  }
  SampleRecipe recipe = context.settings().loose;
  recipe.material.rolling_friction = 0.0;
  add_peak(context, recipe, "mu_r = 0", "", record);
  recipe.material.sliding_friction = 0.0;
  add_peak(context, recipe, "mu = 0 under tau_0", "shear_stress", record);
  recipe.shear_stress = 0.0;
  recipe.preparation_friction = 0.0;
  add_peak(context, recipe, "mu = mu_r = 0, isotropic", "", record);
  return record;
}

SceneRecord many_grains_scene(const SceneContext& context) {
  SceneRecord record;
  SampleRecipe recipe = context.settings().loose;
  recipe.packing.counts = context.settings().large_lattice;
  const auto& [nx, ny, nz] = recipe.packing.counts;
  add_peak(context, recipe, fmt::format("{} grains", nx * ny * nz), "", record);
  return record;
}

}  // namespace flowslide
