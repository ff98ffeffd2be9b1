// SPDX-License-Identifier: GPL-2.0-or-later
// The contract of all engines: the same tests run on each engine, and again on two MPI ranks.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "dem/make_engine.hpp"
#include "grains/contact_forces.hpp"
#include "grains/contact_law.hpp"
#include "grains/stress.hpp"
#include "process/mpi_session.hpp"
#include "sample/dem_sample.hpp"
#include "sample/failure.hpp"
#include "support/touching_lattice.hpp"

namespace flowslide::engine_contract_test {
namespace {

constexpr double step = 2e-6;  // a tenth of the Rayleigh time of these grains

/// What rounding leaves, relative, in engines that work in double and in the one whose law works in float.
struct Rounding {
  /// Sums of some thousand rounded terms in another order (another engine, rank or list). Float: forces and their sums
  /// on a grain are rounded to 6e-8 of themselves, and add up at random.
  double of_sums;
  /// One evaluation of the law. Positions folded by a period of 36 mm lose one unit in the last place, 7e-18 m, against
  /// overlaps of 1e-5 m. Float: some ten operations rounded to 6e-8 of their results.
  double of_forces;
  /// The stress computed in two ways, each from newly evaluated forces.
  double of_stress;
};
constexpr Rounding in_double{1e-12, 1e-10, 1e-9}, in_float{1e-6, 1e-6, 1e-6};
constexpr double rounding = in_double.of_sums;  ///< of lengths and strains, which every engine keeps in double

class EngineContract : public testing::TestWithParam<std::string> {
 protected:
  const Rounding& tolerance() const { return GetParam() == "native-mixed" ? in_float : in_double; }
  EngineSettings settings() const { return {Material{}, step, 0.0}; }
  std::unique_ptr<Engine> engine(const std::string& log = "contract.log") const {
    return make_engine(GetParam(), testing::TempDir() + log, 0, all_ranks());
  }
  /// A sheared lattice with sliding, rolling and sticking contacts.
  Assembly sheared() const {
    auto e = engine();
    DemSample sample(*e, touching_lattice(), settings());
    sample.start_linear_velocity_field(20.0);
    sample.strain({{20.0, 1.0}, 500, step});
    return e->save();
  }
};

void expect_equal(const CellStress& a, const CellStress& b, double tolerance) {
  const double scale = std::abs(b.normal) + std::abs(b.shear) + std::abs(b.lateral_x);
  EXPECT_NEAR(a.normal, b.normal, tolerance * scale);
  EXPECT_NEAR(a.shear, b.shear, tolerance * scale);
  EXPECT_NEAR(a.transverse, b.transverse, tolerance * scale);
  EXPECT_NEAR(a.lateral_x, b.lateral_x, tolerance * scale);
  EXPECT_NEAR(a.lateral_y, b.lateral_y, tolerance * scale);
}

TEST_P(EngineContract, SaveReturnsWhatWasLoaded) {
  const Assembly before = sheared();
  auto e = engine();
  e->load(before, settings());
  const Assembly after = e->save();
  ASSERT_EQ(after.size(), before.size());
  ASSERT_EQ(after.contacts.size(), before.contacts.size());
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_EQ(after.position[i], before.position[i]);
    EXPECT_EQ(after.velocity[i], before.velocity[i]);
    EXPECT_EQ(after.spin[i], before.spin[i]);
    EXPECT_EQ(after.force[i], before.force[i]);
    EXPECT_EQ(after.torque[i], before.torque[i]);
    EXPECT_EQ(after.radius[i], before.radius[i]);
    EXPECT_EQ(after.role[i], before.role[i]);
  }
  for (std::size_t c = 0; c < before.contacts.size(); ++c) {
    EXPECT_EQ(after.contacts[c].first, before.contacts[c].first);
    EXPECT_EQ(after.contacts[c].second, before.contacts[c].second);
    EXPECT_EQ(after.contacts[c].tangential_spring, before.contacts[c].tangential_spring);
    EXPECT_EQ(after.contacts[c].rolling_torque, before.contacts[c].rolling_torque);
  }
}

TEST_P(EngineContract, TwoRunsWithSaveAndLoadBetweenEqualOneRun) {
  const Assembly start = sheared();
  const BoundaryMotion motion{Vector3::Zero(), {0.5, 0.0, -0.01}, 0.0, 0.0};
  auto whole = engine(), parts = engine();
  whole->load(start, settings());
  whole->move(motion);
  whole->run(200);
  parts->load(start, settings());
  parts->move(motion);
  parts->run(100);
  const Assembly middle = parts->save();
  parts->load(middle, settings());
  parts->move(motion);
  parts->run(100);
  expect_equal(parts->cell_stress(), whole->cell_stress(), tolerance().of_sums);
}

TEST_P(EngineContract, ManyShortRunsEqualOneLongRun) {
  const Assembly start = sheared();
  auto whole = engine(), parts = engine();
  for (Engine* e : {whole.get(), parts.get()}) e->load(start, settings());
  whole->run(60);
  for (int i = 0; i < 20; ++i) parts->run(3);
  expect_equal(parts->cell_stress(), whole->cell_stress(), 0.0);
}

TEST_P(EngineContract, NothingChangesWithoutAStep) {
  auto e = engine();
  DemSample sample(*e, sheared(), settings());
  sample.strain({{1.0, 0.0}, 100, step});
  const CellStress before = sample.stress();
  const double strain = sample.shear_strain();
  expect_equal(sample.strain({{5.0, 5.0}, 0, step}), before, 0.0);
  EXPECT_EQ(sample.shear_strain(), strain);
}

TEST_P(EngineContract, UndrainedShearKeepsTheVolume) {
  auto e = engine();
  DemSample sample(*e, touching_lattice(), settings());
  const double before = sample.void_ratio();
  sample.strain({{10.0, 0.0}, 2000, step});
  EXPECT_NEAR(sample.void_ratio(), before, 1e-12);
  EXPECT_NEAR(sample.shear_strain(), 10.0 * 2000 * step, rounding);
}

TEST_P(EngineContract, CompressionShortensTheCellAtItsRate) {
  auto e = engine();
  e->load(touching_lattice(), settings());
  const Cell before = e->cell();
  BoundaryMotion motion;
  motion.compression_rate_x = 0.5;
  motion.compression_rate_y = -0.25;
  e->move(motion);
  e->run(100);
  EXPECT_NEAR(e->cell().lengths().x(), before.lengths().x() * std::pow(1.0 - 0.5 * step, 100), rounding);
  EXPECT_NEAR(e->cell().lengths().y(), before.lengths().y() * std::pow(1.0 + 0.25 * step, 100), rounding);
  EXPECT_NEAR(e->cell().height(), before.height(), rounding);
  EXPECT_EQ(e->count_grains(), touching_lattice().size());
}

TEST_P(EngineContract, ForcesAreThoseOfTheContactLaw) {
  const Assembly assembly = sheared();
  const Material material;
  const PlaneVelocities planes{{0.0, 0.0, 0.0}, {0.0, 0.0, -touching_lattice().cell.height()}};
  const GrainForces expected =
      sum_on_grains(evaluate_contact_forces(assembly, material, step, planes), assembly.size());
  double largest = 0.0, force_error = 0.0, torque_error = 0.0;
  for (std::size_t i = 0; i < assembly.size(); ++i) {
    largest = std::max(largest, assembly.force[i].norm());
    force_error = std::max(force_error, (assembly.force[i] - expected.force[i]).norm());
    torque_error = std::max(torque_error, (assembly.torque[i] - expected.torque[i]).norm());
  }
  EXPECT_LT(force_error, tolerance().of_forces * largest);
  EXPECT_LT(torque_error, tolerance().of_forces * largest * 3e-3);
}

TEST_P(EngineContract, CheapStressIsBagisStress) {
  const Assembly assembly = sheared();
  auto e = engine();
  e->load(assembly, settings());
  e->run(1);
  const Assembly now = e->save();
  const ContactForces forces = evaluate_contact_forces(now, Material{}, step);
  const SlopeStress bagi = slope_stress(bagi_stress(now, forces));
  const CellStress cheap = e->cell_stress();
  EXPECT_NEAR(cheap.normal, bagi.normal, tolerance().of_stress * bagi.normal);
  EXPECT_NEAR(cheap.shear, bagi.shear, tolerance().of_stress * bagi.normal);
  EXPECT_NEAR(cheap.mean(), bagi.mean, tolerance().of_stress * bagi.normal);
}

TEST_P(EngineContract, StressAtRestIsTheForceOnTheGluedLayerOverItsArea) {
  auto e = engine();
  EngineSettings damped = settings();
  damped.drag = 0.5;  // brings the lattice to rest
  e->load(touching_lattice(), damped);
  e->run(5000);
  const Assembly rest = e->save();
  Vector3 layer = Vector3::Zero();
  for (std::size_t i = 0; i < rest.size(); ++i)
    if (rest.role[i] == Role::top_layer) layer += rest.force[i];
  const CellStress stress = e->cell_stress();
  // What is left of the motion keeps the two apart: what is allowed is the unbalanced force over the area.
  double unbalanced = 0.0;
  for (std::size_t i = 0; i < rest.size(); ++i)
    if (rest.role[i] == Role::mobile) unbalanced += rest.force[i].norm();
  const double within = unbalanced / rest.cell.area() + tolerance().of_sums * stress.normal;
  EXPECT_LT(within, 0.01 * stress.normal);
  EXPECT_NEAR(stress.normal, layer.z() / rest.cell.area(), within);
  EXPECT_NEAR(stress.shear, -layer.x() / rest.cell.area(), within);
}

TEST_P(EngineContract, DragTakesEnergyAndIsNoStress) {
  auto e = engine();
  Assembly gas = touching_lattice();
  gas.cell.upper *= 2.0;  // no contacts: grains keep to the lower half
  for (std::size_t i = 0; i < gas.size(); ++i) gas.position[i] *= 2.0;
  EngineSettings damped = settings();
  damped.drag = 0.03;
  e->load(gas, damped);
  e->run(1000);
  const Assembly after = e->save();
  const CellStress stress = e->cell_stress();
  EXPECT_NEAR(stress.normal, 0.0, 1e-9);
  for (std::size_t i = 0; i < gas.size(); ++i) {
    if (gas.role[i] != Role::mobile) continue;
    const double mass = sphere_mass(gas.radius[i], Material{});
    const double expected = std::exp(-damped.drag / mass * 1000 * step);
    // Half-step drag is first order: c dt / 2m = 1e-4 relative.
    EXPECT_NEAR(after.velocity[i].norm() / gas.velocity[i].norm(), expected, 3e-4 * expected);
  }
}

TEST_P(EngineContract, InternalForcesKeepMomentum) {
  auto e = engine();
  Assembly start = touching_lattice();
  start.cell.periodic = {true, true, true};
  for (Role& role : start.role) role = Role::mobile;
  Vector3 before = Vector3::Zero(), after = Vector3::Zero();
  double scale = 0.0;
  e->load(start, settings());
  e->run(500);
  const Assembly end = e->save();
  for (std::size_t i = 0; i < start.size(); ++i) {
    const double mass = sphere_mass(start.radius[i], Material{});
    before += mass * start.velocity[i];
    after += mass * end.velocity[i];
    scale += mass * end.velocity[i].norm() + 500 * step * end.force[i].norm();
  }
  EXPECT_LT((after - before).norm(), tolerance().of_sums * scale);
}

TEST_P(EngineContract, CountsGrainsAndStopsWhenOneLeaves) {
  auto e = engine();
  Assembly assembly = touching_lattice();
  DemSample whole(*e, assembly, settings());
  EXPECT_EQ(e->count_grains(), assembly.size());
  for (std::size_t i = 0; i < assembly.size(); ++i)
    if (assembly.role[i] == Role::mobile && assembly.position[i].z() > 0.7 * assembly.cell.height()) {
      assembly.velocity[i].z() = 2e4;  // through layer and plane within one step of 2e-6 s
      break;
    }
  DemSample leaking(*e, assembly, settings());
  EXPECT_THROW(leaking.strain({{0.0, 0.0}, 20, step}), NumericalFailure);
}

TEST_P(EngineContract, ChangedSettingsHoldFromTheNextStep) {
  auto e = engine();
  e->load(sheared(), settings());
  EngineSettings changed = settings();
  changed.time_step = 0.5 * step;
  changed.material.sliding_friction = 0.1;
  e->set(changed);
  e->run(1);
  const Assembly now = e->save();
  const GrainForces expected =
      sum_on_grains(evaluate_contact_forces(now, changed.material, changed.time_step), now.size());
  double largest = 0.0, error = 0.0;
  for (std::size_t i = 0; i < now.size(); ++i) {
    largest = std::max(largest, expected.force[i].norm());
    error = std::max(error, (now.force[i] - expected.force[i]).norm());
  }
  EXPECT_LT(error, tolerance().of_forces * largest);
}

void change(double& value) { value *= 1.1; }
void change(bool& value) { value = !value; }
void change(DragReference& reference) { reference = DragReference::uniform_compression; }

/// Settings with one field changed, by its name: a number is a tenth larger. The contact law is each of the others.
std::map<std::string, EngineSettings> settings_with_one_change(const EngineSettings& settings) {
  std::map<std::string, EngineSettings> all;
  for_each_leaf(settings, [&]<typename F, typename Value>(const std::string& name, const F&, const Value&) {
    if constexpr (std::is_same_v<Value, ContactLaw>) return;
    EngineSettings& changed = all[name] = settings;
    for_each_leaf(changed, [&]<typename G, typename Other>(const std::string& other, const G&, Other& value) {
      if constexpr (!std::is_same_v<Other, ContactLaw>)
        if (other == name) change(value);
    });
  });
  for (const std::string& law : contact_law_names())
    if (law != name_of(settings.material.contact_law))
      (all["material.contact_law = " + law] = settings).material.contact_law = contact_law_of(law);
  return all;
}

double largest_difference_of_velocity(const Assembly& a, const Assembly& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, (a.velocity[i] - b.velocity[i]).norm());
  return largest;
}

TEST_P(EngineContract, EveryFieldOfTheSettingsActsHoweverItIsSet) {
  Assembly start = sheared();
  constexpr std::size_t in_layer = 36;
  for (std::size_t i = 0; i < start.size(); ++i)  // layers then part so fast that the dashpot pulls
    if (start.role[i] == Role::mobile) start.velocity[i].z() += (i / in_layer) % 2 == 0 ? 0.5 : -0.5;
  const BoundaryMotion motion{Vector3::Zero(), {0.5, 0.0, -0.01}, 0.0, 0.0};
  const auto run = [&](const EngineSettings& loaded, const EngineSettings& set_later) {
    auto e = engine();
    e->load(start, loaded);
    e->move(motion);
    if (text_of_fields(set_later) != text_of_fields(loaded)) e->set(set_later);
    e->run(30);
    return e->save();
  };
  EngineSettings damped = settings();
  damped.drag = 0.03;
  const Assembly unchanged = run(damped, damped);
  for (const auto& [name, changed] : settings_with_one_change(damped)) {
    const Assembly with_change = run(changed, changed);
    const double effect = largest_difference_of_velocity(with_change, unchanged);
    EXPECT_GT(effect, 0.0) << name;
    // The same whether it is loaded or set: but for rounding, which in float reaches a hundredth of the weakest effect.
    EXPECT_LT(largest_difference_of_velocity(run(damped, changed), with_change), 0.1 * effect) << name;
  }
}

TEST_P(EngineContract, RefusesASampleWithoutGluedLayersAndAStepTooLong) {
  auto e = engine();
  Assembly loose = touching_lattice();
  for (Role& role : loose.role) role = Role::mobile;
  EXPECT_THROW(DemSample(*e, loose, settings()), std::invalid_argument);
  EngineSettings coarse = settings();
  coarse.time_step = 2e-5;
  EXPECT_THROW(DemSample(*e, touching_lattice(), coarse), std::invalid_argument);
}

TEST_P(EngineContract, EnginesLiveSideBySide) {
  // The stress of the last engine after five runs, which alternate. Each engine has a velocity of its top, m/s.
  const auto last_stress = [&](const std::vector<std::pair<Engine*, double>>& engines) {
    for (const auto& [e, velocity] : engines) {
      e->load(touching_lattice(), settings());
      BoundaryMotion motion;
      motion.top_velocity.x() = velocity;
      e->move(motion);
    }
    for (int part = 0; part < 5; ++part)
      for (const auto& [e, velocity] : engines) e->run(20);
    return engines.back().first->cell_stress();
  };
  const auto alone = engine(), first = engine("contract_first.log"), second = engine("contract_second.log");
  const CellStress expected = last_stress({{alone.get(), 0.2}});
  const CellStress beside_another = last_stress({{first.get(), 0.1}, {second.get(), 0.2}});
  EXPECT_EQ(beside_another.shear, expected.shear);
  EXPECT_EQ(beside_another.normal, expected.normal);
}

INSTANTIATE_TEST_SUITE_P(Engines, EngineContract, testing::ValuesIn(engine_names_of_build()),
                         [](const auto& engine) {
                           std::string name = engine.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace flowslide::engine_contract_test
