// SPDX-License-Identifier: GPL-2.0-or-later
#include "sample/preparation.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "dem/make_engine.hpp"
#include "record/same_bits.hpp"
#include "sample/dem_sample.hpp"
#include "sample/failure.hpp"
#include "sample/mixing.hpp"

namespace flowslide {
namespace {

SampleRecipe small_recipe() {
  SampleRecipe recipe;
  recipe.packing.counts = {5, 5, 6};
  recipe.compaction_rate = 2.0;
  recipe.stress_tolerance = 5e-3;
  return recipe;
}

TEST(Preparation, ReachesItsTargetsAndHoldsThemAtRest) {
  const auto engine = make_engine(engine_names_of_build().front(), testing::TempDir() + "preparation.log");
  const SampleRecipe recipe = small_recipe();
  std::vector<int> stages;
  const PreparedSample sample = prepare_sample(*engine, recipe, [&](const PreparationProgress& progress) {
    if (stages.empty() || stages.back() != progress.stage) stages.push_back(progress.stage);
  });
  EXPECT_EQ(stages, (std::vector<int>{1, 2, 3, 4, 5}));
  const double tolerance = 4.0 * recipe.stress_tolerance * recipe.normal_stress;  // allowed by rest()
  EXPECT_NEAR(sample.stress.normal, recipe.normal_stress, tolerance);
  EXPECT_NEAR(sample.stress.lateral_x, recipe.normal_stress, tolerance);
  EXPECT_NEAR(sample.stress.lateral_y, recipe.normal_stress, tolerance);
  EXPECT_NEAR(sample.stress.shear, recipe.shear_stress, tolerance);
  EXPECT_LT(sample.kinetic_number, recipe.kinetic_tolerance);
  // Random packings of frictional spheres lie between 0.56 and 1; the walls of a small cell add some voids.
  EXPECT_GT(sample.void_ratio, 0.6);
  EXPECT_LT(sample.void_ratio, 1.0);
  EXPECT_TRUE(sample.assembly.cell.periodic[0] && sample.assembly.cell.periodic[1] &&
              !sample.assembly.cell.periodic[2]);
  for (const Role layer : {Role::bottom_layer, Role::top_layer}) {
    const auto glued = std::count(sample.assembly.role.begin(), sample.assembly.role.end(), layer);
    EXPECT_GT(glued, 10);  // of 25 sites
    EXPECT_LT(glued, 40);
  }
  EXPECT_EQ(sample.assembly.size(), 150u);

  DemSample loaded(*engine, sample.assembly, engine->settings());
  const LocalRun rest{{0.0, 0.0}, 500, engine->settings().time_step};
  EXPECT_NEAR(loaded.strain(rest).normal, sample.stress.normal, 1e-3 * sample.stress.normal);
}

TEST(Preparation, WithAPeriodicHeightReachesTheSameTargetsWithoutLayers) {
  const auto engine = make_engine("native", "");
  SampleRecipe recipe = small_recipe();
  recipe.periodic_height = true;
  const PreparedSample sample = prepare_sample(*engine, recipe);
  const double tolerance = 4.0 * recipe.stress_tolerance * recipe.normal_stress;
  EXPECT_NEAR(sample.stress.normal, recipe.normal_stress, tolerance);
  EXPECT_NEAR(sample.stress.lateral_x, recipe.normal_stress, tolerance);
  EXPECT_NEAR(sample.stress.lateral_y, recipe.normal_stress, tolerance);
  EXPECT_NEAR(sample.stress.shear, recipe.shear_stress, tolerance);
  EXPECT_EQ(sample.probe_void_ratio, sample.void_ratio);
  EXPECT_GT(sample.void_ratio, 0.6);
  EXPECT_LT(sample.void_ratio, 1.0);
  EXPECT_TRUE(sample.assembly.cell.periodic[2]);
  EXPECT_EQ(std::count(sample.assembly.role.begin(), sample.assembly.role.end(), Role::mobile), 150);
  // It carries tau_0 across the faces, which have slid to do so.
  EXPECT_NE(sample.assembly.cell.shear_offset, 0.0);
}

/// Recipes that differ in the transition between two stages.
struct Way {
  const char* name;
  bool periodic_height, mixed;
};

class PreparationFromAState : public testing::TestWithParam<Way> {};

TEST_P(PreparationFromAState, GoesOnWithTheSameBits) {
  SampleRecipe recipe = small_recipe();
  recipe.periodic_height = GetParam().periodic_height;
  if (GetParam().mixed) {
    recipe.mixing_velocity = 0.5;
    recipe.drag_reference = DragReference::uniform_compression;
    recipe.drag_stages = {true, true, true, false};
  }
  const int first = GetParam().mixed ? 0 : 1;
  std::vector<PreparationState> states;  // the twentieth of each stage, and the second of the last rest
  int looks = 0;
  const PreparedSample whole =
      prepare_sample(*make_engine("native", "/dev/null"), recipe, [&](const PreparationProgress& now) {
        looks = static_cast<int>(states.size()) + first == now.stage ? looks + 1 : 0;
        if (looks == (now.stage < 5 ? 20 : 2)) states.push_back(now.state());
      });
  ASSERT_EQ(static_cast<int>(states.size()), 6 - first);
  for (const PreparationState& state : states) {
    const PreparedSample resumed = prepare_sample(*make_engine("native", "/dev/null"), recipe, {}, &state);
    EXPECT_EQ(resumed.steps, whole.steps) << "stage " << state.stage;
    EXPECT_EQ(resumed.void_ratio, whole.void_ratio);
    EXPECT_EQ(resumed.kinetic_number, whole.kinetic_number);
    EXPECT_EQ(resumed.stress.normal, whole.stress.normal);
    EXPECT_EQ(resumed.stress.shear, whole.stress.shear);
    expect_same_bits(resumed.assembly, whole.assembly);
  }
  PreparationState other = states.front();
  other.assembly.resize(10);
  EXPECT_THROW(prepare_sample(*make_engine("native", "/dev/null"), recipe, {}, &other), std::invalid_argument);
}

INSTANTIATE_TEST_SUITE_P(Preparations, PreparationFromAState,
                         testing::Values(Way{"lattice", false, false}, Way{"mixed", false, true},
                                         Way{"periodic_height", true, false}, Way{"mixed_periodic_height", true, true}),
                         [](const auto& way) { return way.param.name; });

TEST(Preparation, MixesUntilTheLatticeIsForgottenAndTellsIfItIsNot) {
  SampleRecipe recipe = small_recipe();
  recipe.packing.counts = {8, 8, 9};
  recipe.mixing_velocity = 0.5;
  const auto engine = make_engine("native", "");
  struct Enough {};
  double agitated = 0.0;
  try {
    prepare_sample(*engine, recipe, [&](const PreparationProgress& now) {
      if (now.stage == 0) agitated = std::max(agitated, now.state().assembly.velocity[5].norm());
      if (now.stage == 1) throw Enough{};
    });
  } catch (const Enough&) {
  }
  EXPECT_GT(agitated, 0.1);
  // The first steps of stage 1 have changed little.
  EXPECT_TRUE(lattice_memory(engine->save(), recipe.packing).forgotten());
  recipe.most_steps = 60;
  try {
    prepare_sample(*engine, recipe);
    FAIL() << "60 steps were enough";
  } catch (const NumericalFailure& failure) {
    EXPECT_NE(std::string(failure.what()).find("mixing, after"), std::string::npos) << failure.what();
    EXPECT_NE(std::string(failure.what()).find("faster mixing"), std::string::npos) << failure.what();
  }
}

TEST(Preparation, DragActsInTheStagesThatAreNamed) {
  SampleRecipe recipe = small_recipe();
  recipe.mixing_velocity = 0.5;
  recipe.drag_reference = DragReference::uniform_compression;
  recipe.drag_stages = {false, true, false, true};
  const auto engine = make_engine("native", "");
  std::vector<double> drags(6, -1.0);
  prepare_sample(*engine, recipe, [&](const PreparationProgress& now) {
    drags[static_cast<std::size_t>(now.stage)] = engine->settings().drag;
    EXPECT_EQ(engine->settings().drag_reference, DragReference::uniform_compression);
  });
  EXPECT_EQ(drags, (std::vector<double>{0.0, 0.0, recipe.drag, 0.0, recipe.drag, 0.0}));
}

TEST(Preparation, FrictionAndRestitutionOfItsOwnEndBeforeStageFour) {
  SampleRecipe recipe = small_recipe();
  recipe.mixing_velocity = 0.5;
  recipe.preparation_friction = 0.7;
  recipe.preparation_restitution = 0.4;
  const auto engine = make_engine("native", "");
  std::vector<Material> materials(6);
  prepare_sample(*engine, recipe, [&](const PreparationProgress& now) {
    materials[static_cast<std::size_t>(now.stage)] = engine->settings().material;
  });
  std::vector<double> frictions, restitutions;
  for (const Material& material : materials) {
    frictions.push_back(material.sliding_friction);
    restitutions.push_back(material.restitution);
  }
  const double friction = recipe.material.sliding_friction, restitution = recipe.material.restitution;
  EXPECT_EQ(frictions, (std::vector{0.7, 0.7, 0.7, 0.7, friction, friction}));
  EXPECT_EQ(restitutions, (std::vector{restitution, 0.4, 0.4, 0.4, restitution, restitution}));
}

TEST(Preparation, SaysWhichStageFailed) {
  const auto engine = make_engine(engine_names_of_build().front(), testing::TempDir() + "preparation.log");
  SampleRecipe recipe = small_recipe();
  recipe.most_steps = 60;
  try {
    prepare_sample(*engine, recipe);
    FAIL() << "60 steps were enough";
  } catch (const NumericalFailure& failure) {
    EXPECT_NE(std::string(failure.what()).find("stage 1"), std::string::npos) << failure.what();
  }
}

}  // namespace
}  // namespace flowslide
