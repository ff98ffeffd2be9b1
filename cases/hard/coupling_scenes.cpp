// SPDX-License-Identifier: GPL-2.0-or-later
// Strain passed in small and large increments: dt_G and n_accum over several decades, at a rate that affects the
// sample.
#include <fmt/format.h>

#include "experiments.hpp"
#include "grains/measures.hpp"
#include "scenes.hpp"

namespace flowslide {
namespace {

constexpr double inertial_number = 1e-2;
constexpr double peak_from = 0.005, peak_until = 0.02;  ///< range of strain for the mean shear stress: around its peak
constexpr const char* high_rate = "rate = \"constant\"\ninertial_number = 1e-2\ninitial_velocity = \"1 cm/s\"\n";
constexpr const char* push = "history = \"constant\"\nchange = \"15 kPa\"\n";

/// Mean shear stress of an element test of the sample at the same rate, Pa.
double alone(const SceneContext& context, const PreparedSample& sample) {
  const SampleRecipe& recipe = context.settings().loose;
  const double rate =
      shear_rate_for(inertial_number, sample.assembly.mean_diameter(), recipe.material.density, recipe.normal_stress);
  return mean_shear(shear(context, sample.assembly, {recipe.material, 1e-5}, {rate, peak_until, 200}), peak_from);
}

/// Mean shear stress of the sample under a slope, Pa, weighted by strain.
double coupled(const SceneContext& context, const PreparedSample& sample, const std::string& coupling) {
  const SlideSettings settings = context.slide(high_rate + coupling, push, context.settings().slope);
  double sum = 0.0, passed = 0.0;
  const auto add = [&](const Slide& slide) {
    const SlideState& state = slide.state();
    if (state.strain.shear < peak_from) return;
    const double strain = state.sliding.velocity * settings.time_step;
    sum += strain * state.stress.shear;
    passed += strain;
  };
  run_slide(context, sample.assembly,
            {.settings = settings,
             .stop = {.end_time = 0.5, .end_shear_strain = peak_until},
             .linear_start = true,
             .observe = add});
  return passed > 0.0 ? sum / passed : 0.0;
}

}  // namespace

SceneRecord exchange_scene(const SceneContext& context) {
  const PreparedSample sample = context.prepared(context.settings().loose);
  const double right = alone(context, sample);
  SceneRecord record;
  for (const double step : {1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 3e-3, 1e-2, 1e-1})
    record.trials.push_back(
        attempt(fmt::format("dt_G = {:.0e} s", step), relative(right, 0.03, 0.1, step > 2e-3 ? "unstable" : ""),
                [&] { return coupled(context, sample, fmt::format("time_step = \"{} s\"\n", step)); }));
  return record;
}

SceneRecord accumulation_scene(const SceneContext& context) {
  const PreparedSample sample = context.prepared(context.settings().loose);
  const double right = alone(context, sample);
  SceneRecord record;
  for (const char* passing : {"carry_remainder", "accumulate_and_reset"})
    for (const int least : {1, 10, 100, 1000})
      record.trials.push_back(attempt(
          fmt::format("n_accum = {}, {}", least, passing), relative(right, 0.03, 0.1, least > 10 ? "n_accum" : ""),
          [&] { return coupled(context, sample, fmt::format("passing = \"{}\"\nn_accum = {}\n", passing, least)); }));
  return record;
}

}  // namespace flowslide
