// SPDX-License-Identifier: GPL-2.0-or-later
// A sample at rest for a long time.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments.hpp"
#include "sample/health.hpp"
#include "scenes.hpp"

namespace flowslide {

SceneRecord rest_scene(const SceneContext& context) {
  constexpr int readings = 100;
  SampleRecipe recipe = context.settings().loose;
  recipe.packing.counts = {5, 5, 4};
  const PreparedSample prepared = context.prepared(recipe);
  const auto engine = context.engine();
  DemSample sample(*engine, prepared.assembly, {recipe.material, 1e-5, 0.0});
  const std::int64_t steps = context.settings().rest_steps / readings;
  double drift = 0.0, first_energy = 0.0, largest_kinetic = 0.0, last_energy = 0.0;
  CellStress first;
  SceneRecord record;
  const std::string duration = fmt::format("{:.0e} steps at rest", static_cast<double>(readings * steps));
  record.trials.push_back(attempt(duration + ": drift of sigma and tau over sigma_0", {0.0, 1e-3, 0.0, 1e-2}, [&] {
    for (int reading = 0; reading < readings; ++reading) {
      sample.strain({{0.0, 0.0}, steps, 1e-5});
      context.stop_if_due();
      const Assembly now = sample.assembly();
      if (reading == 0) {  // residual motion of the preparation has decayed
        first = sample.stress();
        first_energy = energy_of(now, recipe.material);
      }
      drift = std::max({drift, std::abs(sample.stress().normal - first.normal) / recipe.normal_stress,
                        std::abs(sample.stress().shear - first.shear) / recipe.normal_stress});
      last_energy = energy_of(now, recipe.material);
      largest_kinetic = std::max(largest_kinetic, kinetic_number(now, recipe.material, recipe.normal_stress));
    }
    return drift;
  }));
  record.trials.push_back(attempt(duration + ": energy at the end over that at the start", {1.0, 1e-3, 0.99, 1.001},
                                  [&] { return last_energy / first_energy; }));
  record.trials.push_back(
      attempt(duration + ": kinetic number", {0.0, 1e-8, 0.0, 1e-7}, [&] { return largest_kinetic; }));
  return record;
}

}  // namespace flowslide
