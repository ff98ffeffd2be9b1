// SPDX-License-Identifier: GPL-2.0-or-later
#include "sample/dem_sample.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <memory>
#include <thread>
#include <vector>

#include "dem/make_engine.hpp"
#include "dem/native/native_engine.hpp"
#include "grains/bulk_mean_stress.hpp"
#include "grains/measures.hpp"
#include "grains/profiles.hpp"
#include "grains/time_step_share.hpp"
#include "sample/failure.hpp"
#include "sample/health.hpp"
#include "sample/stable_time_step.hpp"
#include "support/touching_lattice.hpp"

namespace flowslide::dem_sample_test {
namespace {

constexpr double step = 2e-6;

class DemSampleTest : public testing::Test {
 protected:
  std::unique_ptr<Engine> engine_ = make_engine(engine_names_of_build().front(), testing::TempDir() + "dem_sample.log");
  EngineSettings settings_{Material{}, step, 0.0};
};

TEST_F(DemSampleTest, ClocksCountStepsAndStrain) {
  DemSample sample(*engine_, touching_lattice(), settings_);
  sample.strain({{2.0, 0.0}, 100, step});
  sample.strain({{-1.0, 0.0}, 50, step});
  EXPECT_EQ(sample.steps(), 150);
  EXPECT_NEAR(sample.time(), 150 * step, 1e-18);
  EXPECT_NEAR(sample.shear_strain(), (2.0 * 100 - 50) * step, 1e-18);
}

TEST_F(DemSampleTest, KeepsTheStressMeasuredLastWhereItNeedNotMeasure) {
  DemSample sample(*engine_, touching_lattice(), settings_);
  const CellStress before = sample.strain({{2.0, 0.0}, 100, step});
  EXPECT_EQ(sample.strain({{2.0, 0.0}, 100, step, false}).shear, before.shear);
  EXPECT_EQ(sample.stress().normal, before.normal);
  EXPECT_EQ(sample.steps(), 200);
  EXPECT_NE(sample.strain({{2.0, 0.0}, 1, step}).shear, before.shear);
  EXPECT_GT(sample.processor_seconds(), 0.0);
  EXPECT_EQ(sample.size(), touching_lattice().size());
}

TEST_F(DemSampleTest, StrainRefersToTheHeightOfTheCellOrToThatBetweenTheLayers) {
  const Assembly lattice = touching_lattice();
  const LayerThickness layers = layer_thickness(lattice);
  const double height = lattice.cell.height(), inner = height - layers.bottom - layers.top;
  ASSERT_LT(inner, 0.95 * height);
  for (const auto& [rule, expected] : {std::pair{StrainHeight::cell, height}, {StrainHeight::between_layers, inner}}) {
    DemSample sample(*engine_, lattice, settings_, rule);
    sample.strain({{2.0, 0.5}, 100, step});
    const Assembly after = sample.assembly();
    const auto top = std::find(after.role.begin(), after.role.end(), Role::top_layer) - after.role.begin();
    const Vector3 moved = after.cell.nearest_image(after.position[top] - lattice.position[top]);
    EXPECT_NEAR(moved.x() / (2.0 * 100 * step), expected, 1e-9 * expected);
    EXPECT_NEAR(-moved.z() / (0.5 * 100 * step), expected, 1e-9 * expected);
  }
}

TEST_F(DemSampleTest, VolumetricStrainChangesTheVoidRatioByItself) {
  DemSample sample(*engine_, touching_lattice(), settings_);
  const double before = sample.void_ratio();
  sample.strain({{0.0, 5.0}, 100, step});
  EXPECT_NEAR((1.0 + sample.void_ratio()) / (1.0 + before), 1.0 - 5.0 * 100 * step, 1e-12);
  EXPECT_NEAR(sample.void_ratio(), void_ratio(sample.assembly()), 1e-12);
}

TEST_F(DemSampleTest, ShearingDownslopeIsResistedByPositiveShearStress) {
  DemSample sample(*engine_, touching_lattice(), settings_);
  EXPECT_GT(sample.strain({{5.0, 0.0}, 500, step}).shear, 0.0);
  DemSample other(*engine_, touching_lattice(), settings_);
  EXPECT_LT(other.strain({{-5.0, 0.0}, 500, step}).shear, 0.0);
}

TEST_F(DemSampleTest, EachRunMayHaveATimeStepOfItsOwn) {
  DemSample sample(*engine_, touching_lattice(), settings_);
  sample.strain({{2.0, 0.0}, 100, step});
  sample.strain({{2.0, 0.0}, 100, 0.3 * step});
  EXPECT_EQ(sample.settings().time_step, 0.3 * step);
  EXPECT_NEAR(sample.time(), 130 * step, 1e-18);
  EXPECT_NEAR(sample.shear_strain(), 2.0 * 130 * step, 1e-18);
  EXPECT_THROW(sample.strain({{2.0, 0.0}, 1, 100 * step}), std::invalid_argument);  // beyond the Rayleigh time
  EXPECT_THROW(sample.strain({{2.0, 0.0}, 1, 0.0}), std::invalid_argument);
}

TEST_F(DemSampleTest, RefusesARunThatIsNoStrainAndStaysUnchanged) {
  DemSample sample(*engine_, touching_lattice(), settings_);
  sample.strain({{2.0, 0.0}, 10, step});
  const double strained = sample.shear_strain();
  EXPECT_THROW(sample.strain({{2.0, 0.0}, -1, step}), std::invalid_argument);
  EXPECT_THROW(sample.strain({{std::nan(""), 0.0}, 1, step}), std::invalid_argument);
  EXPECT_THROW(sample.strain({{2.0, HUGE_VAL}, 1, step, false}), std::invalid_argument);
  EXPECT_EQ(sample.steps(), 10);
  EXPECT_EQ(sample.shear_strain(), strained);
}

TEST_F(DemSampleTest, RefusesAnIncompleteAssembly) {
  const auto refuse = [&](auto&& spoil) {
    Assembly assembly = touching_lattice();
    spoil(assembly);
    EXPECT_THROW(DemSample(*engine_, assembly, settings_), std::invalid_argument);
  };
  refuse([](Assembly& a) { a = {}; });
  refuse([](Assembly& a) { a.role.pop_back(); });
  refuse([](Assembly& a) { a.force.pop_back(); });
  refuse([](Assembly& a) { a.contacts.push_back({0, static_cast<std::uint32_t>(a.size())}); });
  EXPECT_THROW(DemSample(nullptr, touching_lattice(), settings_), std::invalid_argument);
}

TEST_F(DemSampleTest, StopsWhenContactsHaveBecomeTooStiffForTheTimeStep) {
  const Assembly lattice = touching_lattice();
  settings_.material.restitution = 0.3;  // dashpots lower the stability limit below the Rayleigh rule
  double edge = 5e-6;
  for (int i = 0; i < 40; ++i) edge /= std::sqrt(time_step_share(lattice, settings_.material, edge));
  settings_.time_step = 0.97 * edge;  // suits the lattice as it is
  DemSample sample(*engine_, lattice, settings_);
  const std::int64_t steps = time_step_interval;
  const double squeeze = 0.004 / (static_cast<double>(steps) * settings_.time_step);
  EXPECT_THROW(sample.strain({{0.0, squeeze}, steps, settings_.time_step}), NumericalFailure);
  settings_.time_step = 1.03 * edge;
  EXPECT_THROW(DemSample(*engine_, lattice, settings_), NumericalFailure);
}

TEST_F(DemSampleTest, MeanStressIsThatOfTheBulkWithItsKineticPart) {
  DemSample sample(*engine_, touching_lattice(), settings_);
  sample.strain({{2.0, 0.0}, 100, step});
  const Assembly assembly = sample.assembly();
  const ContactForces forces = evaluate_contact_forces(assembly, settings_.material, step);
  EXPECT_EQ(sample.mean_stress(), bulk_mean_stress(assembly, forces, settings_.material));
  EXPECT_GT(sample.mean_stress(), 1e3);
}

TEST_F(DemSampleTest, ALinearVelocityFieldReachesFromTheBottomToTheTop) {
  DemSample sample(*engine_, touching_lattice(), settings_);
  const Assembly before = sample.assembly();
  sample.start_linear_velocity_field(3.0);
  const Assembly after = sample.assembly();
  for (std::size_t i = 0; i < after.size(); ++i) {
    const double expected = after.role[i] == Role::mobile ? 3.0 * after.position[i].z() : 0.0;
    EXPECT_NEAR(after.velocity[i].x() - before.velocity[i].x(), expected, 1e-12);
    EXPECT_EQ(after.velocity[i].z(), before.velocity[i].z());
    // curl of (3 z, 0, 0) is (0, 3, 0); a rigid rotation spins at half its curl
    EXPECT_NEAR(after.spin[i].y() - before.spin[i].y(), after.role[i] == Role::mobile ? 1.5 : 0.0, 1e-12);
  }
}

TEST_F(DemSampleTest, TheLinearVelocityFieldMayWaitForTheFirstStrain) {
  DemSample at_once(*engine_, touching_lattice(), settings_);
  at_once.start_linear_velocity_field(3.0);
  at_once.strain({{3.0, 0.0}, 20, step});
  const double expected = at_once.strain({{1.0, 0.0}, 20, step}).shear;
  DemSample waiting(*engine_, touching_lattice(), settings_);
  waiting.start_linear_at_first_strain();
  waiting.strain({{3.0, 0.0}, 20, step});
  EXPECT_EQ(waiting.strain({{1.0, 0.0}, 20, step}).shear, expected);  // and the second strain starts nothing
}

/// A lattice without planes and layers.
Assembly lattice_without_layers() {
  Assembly lattice = touching_lattice(8, 9);
  lattice.cell.periodic = {true, true, true};
  for (Role& role : lattice.role) role = Role::mobile;
  return lattice;
}

TEST(ShearedSample, IsShearedLinearlyInLooseAndInDenserFlow) {
  double loose = 0.0;  // sigma, Pa
  for (const double compression : {0.0, 0.09}) {  // of the lattice, which is far looser than any packing
    NativeEngine<double> engine({.threads = 1});
    DemSample sample(engine, lattice_without_layers(), {Material{}, 2.5 * step, 0.0});
    const double before = sample.void_ratio();
    sample.start_linear_velocity_field(50.0);
    const double rate = compression / (20 * 400 * 2.5 * step * (1.0 - 0.5 * compression));  // per height at each start
    double thinner = 1.0;
    for (int part = 0; part < 20; ++part) {
      sample.strain({{50.0, rate}, 400, 2.5 * step});
      thinner *= 1.0 - rate * 400 * 2.5 * step;
    }
    EXPECT_NEAR((1.0 + sample.void_ratio()) / (1.0 + before), thinner, 1e-11);
    EXPECT_NEAR(sample.void_ratio(), void_ratio(sample.assembly()), 1e-12);
    double tau = 0.0, sigma = 0.0;
    std::vector<double> velocity(9, 0.0);
    for (int look = 0; look < 40; ++look) {
      const CellStress stress = sample.strain({{50.0, 0.0}, 400, 2.5 * step});
      tau += stress.shear / 40.0;
      sigma += stress.normal / 40.0;
      const Profiles now = profiles(sample.assembly(), {}, 9);
      for (std::size_t k = 0; k < 9; ++k) velocity[k] += now.velocity[k] / 40.0;
    }
    EXPECT_NEAR(sample.shear_strain(), 50.0 * 60 * 400 * 2.5 * step, 1e-12);
    EXPECT_GT(tau, 0.1 * sigma);
    EXPECT_LT(tau, sigma);
    if (compression > 0.0)
      EXPECT_GT(sigma, 2.0 * loose);
    else
      loose = sigma;
    double off = 0.0, all = 0.0;  // about the line of the shear, from 0 at the bottom to rate times height at the top
    const double height = engine.cell().height(), top = 50.0 * height;
    for (std::size_t k = 0; k < 9; ++k) {
      const double middle = (static_cast<double>(k) + 0.5) / 9.0;
      off += std::pow(velocity[k] - middle * top, 2);
      all += std::pow((middle - 0.5) * top, 2);
    }
    std::printf("sigma %.4g Pa, tau %.4g Pa, R^2 %.5f\n", sigma, tau, 1.0 - off / all);
    EXPECT_LT(off, 0.02 * all);
  }
}

TEST(ShearedSample, GoesOnWithTheSameBits) {
  NativeEngine<double> engine({.threads = 1}), other({.threads = 1});
  DemSample whole(engine, lattice_without_layers(), {Material{}, step, 0.0});
  whole.strain({{30.0, 0.5}, 3000, step});
  const SampleState state = whole.state();
  DemSample second(other, lattice_without_layers(), {Material{}, step, 0.0});
  second.restore(state);
  for (DemSample* sample : {&whole, &second}) sample->strain({{40.0, -0.2}, 3000, step});
  const Assembly expected = whole.assembly(), reached = second.assembly();
  EXPECT_EQ(reached.cell.shear_offset, expected.cell.shear_offset);
  EXPECT_EQ(second.stress().shear, whole.stress().shear);
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(reached.position[i], expected.position[i]);
}

TEST(ShearedSample, HasNoLayersAndIsNoneOfLiggghts) {
  NativeEngine<double> engine({.threads = 1});
  Assembly glued = lattice_without_layers();
  glued.role.front() = Role::bottom_layer;
  EXPECT_THROW(DemSample(engine, glued, {Material{}, step, 0.0}), std::invalid_argument);
  const auto liggghts = make_engine("liggghts", testing::TempDir() + "sheared_sample.log");
  EXPECT_THROW(DemSample(*liggghts, lattice_without_layers(), {Material{}, step, 0.0}), EngineError);
  EXPECT_THROW(liggghts->move({Vector3::Zero(), Vector3(1.0, 0.0, 0.0), 0.0, 0.0}), EngineError);
}

/// The same exchanges, once as a whole and once from a state that was stored after some of them.
class DemSampleGoesOn : public testing::Test {
 protected:
  static void strain(Sample& sample, int from, int to) {
    for (int i = from; i < to; ++i)
      sample.strain({{3.0 + i, 0.1 * i}, 20 + i, (i % 2 ? 1.0 : 0.7) * step});
  }
  static DemSample sample_on(Engine& engine) {
    return DemSample(engine, touching_lattice(), {Material{}, step, 0.0});
  }
};

TEST_F(DemSampleGoesOn, WithTheSameBitsOnAnyNumberOfThreads) {
  for (const int threads : {1, 3}) {
    NativeEngine<double> engine({.threads = 1}), others({.threads = threads, .first_allowance = 0.01});
    DemSample whole = sample_on(engine);
    strain(whole, 0, 5);
    const SampleState state = whole.state();
    strain(whole, 5, 12);
    DemSample second = sample_on(others);
    second.restore(state);
    EXPECT_EQ(second.steps(), static_cast<std::int64_t>(state.number("steps")));
    strain(second, 5, 12);
    SampleState expected = whole.state(), reached = second.state();
    EXPECT_GE(reached.number("processor_seconds"), state.number("processor_seconds"));
    for (SampleState* s : {&expected, &reached}) s->numbers.erase("processor_seconds");
    EXPECT_EQ(reached.numbers, expected.numbers);
    for (std::size_t i = 0; i < expected.grains->size(); ++i) {
      EXPECT_EQ(reached.grains->position[i], expected.grains->position[i]);
      EXPECT_EQ(reached.grains->velocity[i], expected.grains->velocity[i]);
    }
  }
}

TEST_F(DemSampleGoesOn, WithTheStableTimeStepThatItFoundLast) {
  // Smaller grains touch less, until a stable step of their contacts is beyond the limit of other steps.
  Assembly loose = touching_lattice();
  while (stable_time_step(loose, {}, step) <= longest_time_step(loose.smallest_radius(), {}))
    for (double& radius : loose.radius) radius *= 0.9999;
  const auto sample_on_loose = [&] {
    return std::make_unique<DemSample>(std::make_unique<DoubleEngine>(), loose, EngineSettings{Material{}, step, 0.0});
  };
  const auto first = sample_on_loose(), second = sample_on_loose();
  const double stable = first->stable_time_step();
  ASSERT_THROW(second->strain({{1.0, 0.0}, 1, stable}), std::invalid_argument);
  second->restore(first->state());
  EXPECT_EQ(second->state().number("stable_time_step"), stable);
  EXPECT_NO_THROW(second->strain({{1.0, 0.0}, 1, stable}));
}

TEST_F(DemSampleGoesOn, FromAnEarlierStateOfItsOwn) {
  DemSample sample(std::make_unique<DoubleEngine>(), touching_lattice(), {Material{}, step, 0.0});
  strain(sample, 0, 3);
  const SampleState state = sample.state();
  strain(sample, 3, 8);
  const SampleState expected = sample.state();
  sample.restore(state);
  EXPECT_EQ(sample.steps(), static_cast<std::int64_t>(state.number("steps")));
  strain(sample, 3, 8);
  EXPECT_EQ(sample.stress().shear, expected.number("shear_stress"));
  const Assembly reached = sample.assembly();
  for (std::size_t i = 0; i < reached.size(); ++i) EXPECT_EQ(reached.position[i], expected.grains->position[i]);
}

TEST_F(DemSampleGoesOn, UnchangedWhereAStateIsRefused) {
  DemSample sample(std::make_unique<DoubleEngine>(), touching_lattice(), {Material{}, step, 0.0});
  strain(sample, 0, 2);
  const SampleState before = sample.state();
  strain(sample, 2, 4);
  SampleState spoilt = before;
  spoilt.numbers.erase("shear_stress");
  const double stress = sample.stress().shear, strained = sample.shear_strain();
  const Vector3 position = sample.assembly().position[20];
  EXPECT_THROW(sample.restore(spoilt), std::invalid_argument);
  EXPECT_EQ(sample.stress().shear, stress);
  EXPECT_EQ(sample.shear_strain(), strained);
  EXPECT_EQ(sample.assembly().position[20], position);
}

TEST_F(DemSampleGoesOn, WithTheSameBitsBesideAnotherInAThreadOfItsOwn) {
  const auto new_sample = [] {
    return std::make_unique<DemSample>(std::make_unique<DoubleEngine>(NativeOptions{.threads = 1}), touching_lattice(),
                                       EngineSettings{Material{}, step, 0.0});
  };
  const auto alone = new_sample();
  strain(*alone, 0, 20);
  std::vector<std::unique_ptr<DemSample>> samples;
  for (int k = 0; k < 4; ++k) samples.push_back(new_sample());
  std::vector<std::thread> threads;
  for (const auto& sample : samples) threads.emplace_back([&sample] { strain(*sample, 0, 20); });
  for (std::thread& thread : threads) thread.join();
  for (const auto& sample : samples) {
    EXPECT_EQ(sample->stress().shear, alone->stress().shear);
    EXPECT_EQ(sample->stress().normal, alone->stress().normal);
  }
}

TEST_F(DemSampleGoesOn, ButNotFromTheStateOfAnother) {
  NativeEngine<double> engine({.threads = 1});
  DemSample sample = sample_on(engine);
  const SampleState state = sample.state();
  const auto refuse = [&](auto&& spoil) {
    SampleState other = state;
    spoil(other);
    EXPECT_THROW(sample.restore(other), std::invalid_argument);
  };
  refuse([](SampleState& s) { s.grains.reset(); });
  refuse([](SampleState& s) { s.grains->resize(s.grains->size() + 1); });
  refuse([](SampleState& s) { s.grains->velocity.pop_back(); });
  refuse([](SampleState& s) { s.numbers["prepared_normal_stress"] += 1.0; });
  refuse([](SampleState& s) { s.numbers["time_step"] = 1.0; });
  refuse([](SampleState& s) { s.numbers["steps"] = 0.5; });
  refuse([](SampleState& s) { s.numbers.erase("time"); });
}

TEST(DemSampleSettings, AreRefusedOutOfTheirBounds) {
  const auto complaint = [](auto&& change) -> std::string {
    EngineSettings settings{Material{}, step, 0.0};
    change(settings);
    DoubleEngine engine;
    try {
      DemSample(engine, touching_lattice(), settings);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(complaint([](EngineSettings& s) { s.material.restitution = 1.5; }),
            "material.restitution = 1.5 is not allowed: it must be above 0 and at most 1; change it");
  EXPECT_EQ(complaint([](EngineSettings& s) { s.drag = -1.0; }),
            "drag = -1 kg/s is not allowed: it must be at least 0 kg/s; change it");
}

}  // namespace
}  // namespace flowslide::dem_sample_test
