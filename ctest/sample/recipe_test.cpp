// SPDX-License-Identifier: GPL-2.0-or-later
#include "sample/recipe.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/perturb.hpp"

namespace flowslide {
namespace {

using Change = std::function<void(SampleRecipe&)>;

TEST(Recipe, TheSmallestChangeOfAnyFieldMakesAnotherText) {
  std::set<std::string> texts{SampleRecipe{}.text()};
  std::set<std::string> limits;
  for_each_perturbation(SampleRecipe{}, [&](const std::string& name, const auto& field, const SampleRecipe& changed) {
    if (field.effect == Effect::limit_only)
      limits.insert(name);
    else
      EXPECT_TRUE(texts.insert(changed.text()).second) << name;
  });
  EXPECT_GE(texts.size(), 31u);  // 30 numbers and flags when this test was written
  EXPECT_EQ(limits, std::set<std::string>{"most_steps"});
}

TEST(Recipe, AcceptsThePapersSample) { EXPECT_NO_THROW(validate(SampleRecipe{})); }

TEST(Recipe, RefusesWhatCannotBePrepared) {
  const std::vector<Change> mistakes{
      [](SampleRecipe& r) { r.packing.counts[2] = 2; },
      [](SampleRecipe& r) { r.packing.smallest_diameter = 0.0; },
      [](SampleRecipe& r) { r.packing.smallest_diameter = -5e-3; },
      [](SampleRecipe& r) { r.material.youngs_modulus = 0.0; },
      [](SampleRecipe& r) { r.material.poisson_ratio = 0.5; },
      [](SampleRecipe& r) { r.normal_stress = 0.0; },
      [](SampleRecipe& r) { r.shear_stress = 0.6 * r.normal_stress; },
      [](SampleRecipe& r) { r.material.sliding_friction = 0.0; },
      [](SampleRecipe& r) { r.preparation_friction = -0.1; },
      [](SampleRecipe& r) { r.drag = -1.0; },
      [](SampleRecipe& r) { r.preparation_restitution = 0.0; },
      [](SampleRecipe& r) { r.loose_void_ratio = 0.7; },
      [](SampleRecipe& r) { r.compaction_rate = 0.0; },
      [](SampleRecipe& r) { r.servo_rates[0] = 0.0; },
      [](SampleRecipe& r) { r.servo_interval = 0; },
      [](SampleRecipe& r) { r.stress_tolerance = 0.0; },
      [](SampleRecipe& r) { r.time_step = 1.2e-5; },  // 0.77 Rayleigh times
      [](SampleRecipe& r) { r.time_step = std::nan(""); },
      [](SampleRecipe& r) { r.mixing_velocity = -0.5; },
      [](SampleRecipe& r) { r.mixing_velocity = 50.0; },
  };
  for (std::size_t i = 0; i < mistakes.size(); ++i) {
    SampleRecipe recipe;
    mistakes[i](recipe);
    EXPECT_THROW(validate(recipe), std::invalid_argument) << "mistake " << i;
  }
}

TEST(Recipe, GrainsWithoutFrictionMayBeIsotropic) {
  SampleRecipe recipe;
  recipe.material.sliding_friction = recipe.preparation_friction = recipe.shear_stress = 0.0;
  EXPECT_NO_THROW(validate(recipe));
}

}  // namespace
}  // namespace flowslide
