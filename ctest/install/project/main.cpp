// SPDX-License-Identifier: GPL-2.0-or-later
// A slide on the elastic sample, and some grains of the native engine, from an installed library.
#include <cmath>
#include <cstdio>

#include <flowslide/coupling/slide.hpp>
#include <flowslide/dem/native/native_engine.hpp>
#include <flowslide/sample/elastic_sample.hpp>
#include <flowslide/sample/preparation.hpp>

using namespace flowslide;

namespace {

/// A slope in balance, pushed at 1 mm/s, swings back: m x'' = -G x/h_s, so that v falls to 0 after a quarter period.
bool swings() {
  SlideSettings settings;
  ElasticProperties soil;
  soil.shear_stress = initial_shear_stress(settings.slope);
  soil.normal_stress = initial_normal_stress(settings.slope);
  settings.initial_velocity = 1e-3;
  settings.time_step = 1e-5;
  const double thickness = settings.slope.liquefiable_thickness;
  const double omega = std::sqrt(soil.shear_modulus / (thickness * mass_per_area(settings.slope)));
  ElasticSample sample(soil);
  Slide slide(settings, sample);
  while (slide.state().velocity > 0.0 && slide.state().time < 10.0) slide.step();
  const double quarter = std::acos(-1.0) / (2.0 * omega);
  std::printf("elastic slide: turns after %.6g s, exactly %.6g s\n", slide.state().time, quarter);
  return std::abs(slide.state().time - quarter) <= 2.0 * settings.time_step;   // the step of the turn
}

bool stands() {
  SampleRecipe recipe;
  recipe.packing.counts = {5, 5, 6};
  recipe.compaction_rate = 2.0;
  recipe.stress_tolerance = 5e-3;
  DoubleEngine engine;
  const PreparedSample sample = prepare_sample(engine, recipe);
  std::printf("%zu grains: e_0 = %.4f, sigma = %.6g Pa\n", sample.assembly.size(), sample.void_ratio,
              sample.stress.normal);
  return std::abs(sample.stress.normal / recipe.normal_stress - 1.0) < 4.0 * recipe.stress_tolerance;
}

}  // namespace

int main() { return swings() && stands() ? 0 : 1; }
