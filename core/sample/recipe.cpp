// SPDX-License-Identifier: GPL-2.0-or-later
#include "sample/recipe.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "sample/health.hpp"

namespace flowslide {

std::string SampleRecipe::text() const {
  std::string text = "preparation = 1\n";  // to be raised when the procedure changes
  const auto add = [&](const char* name, auto value) { text += fmt::format("{} = {}\n", name, value); };
  add("lattice", fmt::format("{} x {} x {}", packing.counts[0], packing.counts[1], packing.counts[2]));
  add("smallest_diameter", packing.smallest_diameter);
  add("largest_diameter", packing.largest_diameter);
  add("spacing", packing.spacing);
  add("jitter", packing.jitter);
  add("seed", packing.seed);
  add("density", material.density);
  add("youngs_modulus", material.youngs_modulus);
  add("poisson_ratio", material.poisson_ratio);
  add("restitution", material.restitution);
  add("sliding_friction", material.sliding_friction);
  add("rolling_friction", material.rolling_friction);
  add("rolling_stiffness", material.rolling_stiffness);
  add("rolling_viscous_damping", material.rolling_viscous_damping);
  add("normal_stress", normal_stress);
  add("shear_stress", shear_stress);
  add("preparation_friction", preparation_friction);
  add("drag", drag);
  add("time_step", time_step);
  add("loose_void_ratio", loose_void_ratio);
  add("compaction_rate", compaction_rate);
  add("servo_rates", fmt::format("{} {} {}", servo_rates[0], servo_rates[1], servo_rates[2]));
  add("servo_interval", servo_interval);
  add("stress_tolerance", stress_tolerance);
  add("kinetic_tolerance", kinetic_tolerance);
  if (periodic_height) add("periodic_height", periodic_height);
  return text;
}

void validate(const SampleRecipe& recipe) {
  validate(recipe.packing);
  const auto require = [](bool holds, const char* name, double value, const char* allowed) {
    if (!holds)
      throw std::invalid_argument(fmt::format("{} = {} of the sample recipe is not possible: it must be {}", name,
                                              value, allowed));
  };
  require(recipe.normal_stress > 0.0, "normal_stress", recipe.normal_stress, "> 0 Pa");
  require(recipe.shear_stress == 0.0 ||
              std::abs(recipe.shear_stress) < recipe.material.sliding_friction * recipe.normal_stress,
          "shear_stress", recipe.shear_stress, "0, or smaller than sliding_friction times normal_stress: no packing bears more");
  require(recipe.preparation_friction >= 0.0, "preparation_friction", recipe.preparation_friction, ">= 0");
  require(recipe.drag >= 0.0, "drag", recipe.drag, ">= 0 kg/s");
  require(recipe.loose_void_ratio > 0.95, "loose_void_ratio", recipe.loose_void_ratio,
          "> 0.95, looser than any packing at rest");
  require(recipe.compaction_rate > 0.0, "compaction_rate", recipe.compaction_rate, "> 0 1/s");
  for (const double rate : recipe.servo_rates) require(rate > 0.0, "servo_rates", rate, "> 0 1/s");
  require(recipe.servo_interval >= 1, "servo_interval", recipe.servo_interval, ">= 1 step");
  require(recipe.stress_tolerance > 0.0 && recipe.stress_tolerance < 0.1, "stress_tolerance",
          recipe.stress_tolerance, "between 0 and 0.1");
  require(recipe.kinetic_tolerance > 0.0, "kinetic_tolerance", recipe.kinetic_tolerance, "> 0");
  validate_time_step(recipe.time_step, 0.5 * recipe.packing.smallest_diameter, recipe.material);
}

}  // namespace flowslide
