// SPDX-License-Identifier: GPL-2.0-or-later
// Prepares a sample of 150 spheres, shears it at constant volume to 2 % and prints its stress.
#include <cstdio>
#include <flowslide/dem/native/native_engine.hpp>
#include <flowslide/sample/dem_sample.hpp>
#include <flowslide/sample/preparation.hpp>
#include <memory>

using namespace flowslide;

int main() {
  SampleRecipe recipe;  // the soil of the paper's Table 1 under sigma_0 = 28.34 kPa and tau_0 = 2.65 kPa
  recipe.packing.counts = {5, 5, 6};
  recipe.compaction_rate = 2.0;     // 1/s
  recipe.stress_tolerance = 5e-3;   // of sigma_0
  DoubleEngine engine;
  const PreparedSample prepared = prepare_sample(engine, recipe);
  DemSample sample(std::make_unique<DoubleEngine>(), prepared.assembly, {recipe.material, recipe.time_step, 0.0});

  std::printf("# e_0 = %.4f\n# gamma  tau (Pa)  sigma (Pa)\n", sample.void_ratio());
  while (sample.shear_strain() < 0.02) {
    const CellStress stress = sample.strain({{.shear = 0.5, .compression = 0.0}, 200, recipe.time_step});
    std::printf("%.4f  %.1f  %.1f\n", sample.shear_strain(), stress.shear, stress.normal);
  }
}
