// SPDX-License-Identifier: GPL-2.0-or-later
#include "program/plan.hpp"

#include <fmt/format.h>

#include <ostream>

#include "dem/make_engine.hpp"
#include "program/versions.hpp"
#include "record/health_line.hpp"
#include "sample/closed_form.hpp"

namespace flowslide {

std::string replicate_name(const std::string& point, int replicate) {
  return replicate == 0 ? point : fmt::format("{}_r{}", point, replicate + 1);
}

double seconds_per_grain_and_step(const std::string& engine) {
  if (engine.starts_with("liggghts")) return 1.6e-7;
  if (engine == "native-mixed") return 2.6e-8;
  return engine == "native" ? 3.7e-8 : 0.0;
}

void print_sample_plan(std::ostream& out, const SampleSpecification& sample, const std::string& preparation_engine) {
  out << fmt::format("# sample {}: e0 = {} +- {}, search from mu_1 = {} and a drag of {} kg/s, seed {}\n", sample.name,
                     sample.target.void_ratio, sample.target.tolerance, sample.recipe.preparation_friction,
                     sample.recipe.drag, sample.recipe.packing.seed);
  out << fmt::format(
      "# key of its first trial in the cache: {}\n",
      cache_key(sample.recipe, preparation_identity(preparation_engine, engine_version(preparation_engine))));
}

void print_found_sample(std::ostream& out, const SampleSpecification& wanted, const FoundSample& found) {
  const SampleRecipe& recipe = found.recipe;
  const std::string packing =
      recipe.mixing_velocity > 0.0 ? fmt::format("mixed at {} m/s", recipe.mixing_velocity) : "lattice";
  out << fmt::format("sample {}, seed {}, mu_1 {}, drag {} kg/s, {}: {}\n", wanted.name, recipe.packing.seed,
                     recipe.preparation_friction, recipe.drag, packing, health_line(metrics_of(found)));
  if (const std::string uneven = unevenness(found.health); !uneven.empty()) out << uneven << "\n";
}

void print_engine_plan(std::ostream& out, const SampleRecipe& recipe, const std::string& engine, double time_step) {
  if (is_closed_form(engine)) return;
  Assembly assembly = lattice_packing(recipe.packing);
  assembly.cell.periodic = {true, true, false};
  const std::vector<std::string> lines = setup_text(engine, assembly, {recipe.material, time_step, 0.0});
  if (lines.empty()) return;
  out << "# LIGGGHTS, with the box of the loose packing in place of the sample's:\n";
  for (const std::string& line : lines) out << line << "\n";
}

}  // namespace flowslide
