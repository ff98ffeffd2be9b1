// SPDX-License-Identifier: GPL-2.0-or-later
#include "sample/recipe.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace flowslide {
namespace {

using Change = std::function<void(SampleRecipe&)>;

TEST(Recipe, TextTellsAnyTwoRecipesApart) {
  const std::vector<Change> changes{
      [](SampleRecipe&) {},
      [](SampleRecipe& r) { r.packing.counts[2] = 11; },
      [](SampleRecipe& r) { r.packing.seed = 2; },
      [](SampleRecipe& r) { r.packing.jitter = 0.03; },
      [](SampleRecipe& r) { r.packing.largest_diameter = 8e-3; },
      [](SampleRecipe& r) { r.material.restitution = 0.7; },
      [](SampleRecipe& r) { r.material.rolling_stiffness = 1.0; },
      [](SampleRecipe& r) { r.normal_stress = std::nextafter(r.normal_stress, 1e9); },
      [](SampleRecipe& r) { r.shear_stress = 0.0; },
      [](SampleRecipe& r) { r.preparation_friction = 0.4; },
      [](SampleRecipe& r) { r.drag = 0.06; },
      [](SampleRecipe& r) { r.time_step = 5e-6; },
      [](SampleRecipe& r) { r.loose_void_ratio = 1.1; },
      [](SampleRecipe& r) { r.compaction_rate = 2.0; },
      [](SampleRecipe& r) { r.servo_rates[1] = 0.2; },
      [](SampleRecipe& r) { r.servo_interval = 20; },
      [](SampleRecipe& r) { r.stress_tolerance = 1e-2; },
      [](SampleRecipe& r) { r.periodic_height = true; },
  };
  std::set<std::string> texts;
  for (const Change& change : changes) {
    SampleRecipe recipe;
    change(recipe);
    texts.insert(recipe.text());
  }
  EXPECT_EQ(texts.size(), changes.size());
}

TEST(Recipe, AcceptsThePapersSample) { EXPECT_NO_THROW(validate(SampleRecipe{})); }

TEST(Recipe, RefusesWhatCannotBePrepared) {
  const std::vector<Change> mistakes{
      [](SampleRecipe& r) { r.packing.counts[2] = 2; },
      [](SampleRecipe& r) { r.packing.smallest_diameter = 0.0; },
      [](SampleRecipe& r) { r.packing.smallest_diameter = -5e-3; },
      [](SampleRecipe& r) { r.normal_stress = 0.0; },
      [](SampleRecipe& r) { r.shear_stress = 0.6 * r.normal_stress; },
      [](SampleRecipe& r) { r.material.sliding_friction = 0.0; },
      [](SampleRecipe& r) { r.preparation_friction = -0.1; },
      [](SampleRecipe& r) { r.drag = -1.0; },
      [](SampleRecipe& r) { r.loose_void_ratio = 0.7; },
      [](SampleRecipe& r) { r.compaction_rate = 0.0; },
      [](SampleRecipe& r) { r.servo_rates[0] = 0.0; },
      [](SampleRecipe& r) { r.servo_interval = 0; },
      [](SampleRecipe& r) { r.stress_tolerance = 0.0; },
      [](SampleRecipe& r) { r.time_step = 1.2e-5; },  // 0.77 Rayleigh times
      [](SampleRecipe& r) { r.time_step = std::nan(""); },
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
