// SPDX-License-Identifier: GPL-2.0-or-later
// Drag relative to the uniform compression of the cell, on every engine, and again on two MPI ranks.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "dem/make_engine.hpp"
#include "dem/uniform_flow.hpp"
#include "grains/contact_forces.hpp"
#include "grains/contact_law.hpp"
#include "grains/stress.hpp"
#include "process/mpi_session.hpp"
#include "sample/dem_sample.hpp"
#include "support/touching_lattice.hpp"

namespace flowslide::drag_contract_test {
namespace {

constexpr double step = 2e-6;   // s
constexpr double drag = 0.03;   // kg/s
constexpr double length = 0.1;  // of the cells below, about, m

EngineSettings settings(double c = drag) { return {Material{}, step, c, DragReference::uniform_compression}; }

/// A cell, and how it moves.
struct Scene {
  const char* name;
  Assembly gas;  ///< grains that do not touch
  BoundaryMotion motion;
};

Assembly gas_in(const std::array<bool, 3>& periodic, bool glued) {
  Assembly gas = touching_lattice();
  gas.cell.upper *= 2.0;
  gas.cell.periodic = periodic;
  for (std::size_t i = 0; i < gas.size(); ++i) {
    gas.position[i] *= 2.0;
    if (!glued) gas.role[i] = Role::mobile;
  }
  return gas;
}

/// The cells of the preparation: stages 1 and 2, 3, and 4.
std::vector<Scene> scenes() {
  const Vector3 still = Vector3::Zero();
  return {{"box", gas_in({false, false, false}, false), {{0, 0, 0.03}, {0, 0, -0.05}, 1.0, 0.5}},
          {"periodic sides", gas_in({true, true, false}, false), {{0, 0, 0.03}, {0, 0, -0.05}, 1.0, 0.5}},
          {"layers", gas_in({true, true, false}, true), {still, {0.3, 0.1, -0.05}, 1.0, 0.5}},
          {"all periodic", gas_in({true, true, true}, false), {}}};
}

/// Gives the mobile grains the velocity of the field and `fluctuation`.
void follow_field(Scene& scene, const Vector3& fluctuation) {
  const UniformFlow flow = uniform_flow(scene.gas.cell, scene.motion);
  for (std::size_t i = 0; i < scene.gas.size(); ++i)
    if (scene.gas.role[i] == Role::mobile) scene.gas.velocity[i] = flow.at(scene.gas.position[i]) + fluctuation;
}

class DragContract : public testing::TestWithParam<std::string> {
 protected:
  std::unique_ptr<Engine> engine() const {
    return make_engine(GetParam(), testing::TempDir() + "drag_contract.log", 0, all_ranks());
  }
  /// Of one force: float rounds sums of forces.
  double rounding() const { return GetParam() == "native-mixed" ? 1e-6 : 1e-12; }
  std::unique_ptr<Engine> ran(const Scene& scene, int steps, const EngineSettings& with = settings()) const {
    auto e = engine();
    e->load(scene.gas, with);
    e->move(scene.motion);
    e->run(steps);
    return e;
  }
};

TEST_P(DragContract, AGrainThatFollowsTheFieldFeelsNone) {
  for (Scene& scene : scenes()) {
    follow_field(scene, Vector3::Zero());
    const Assembly after = ran(scene, 1)->save();
    // The field of a rigid side that shortens at the rate r speeds a grain at the distance a up by r^2 a: after a step
    // the grain is behind by r^2 a dt.
    const double behind = std::pow(scene.motion.compression_rate_x, 2) * length * step + rounding();
    for (std::size_t i = 0; i < after.size(); ++i)
      if (after.role[i] == Role::mobile) {
        EXPECT_LT(after.force[i].norm(), drag * behind) << scene.name << " " << i;
      }
  }
}

TEST_P(DragContract, WhatIsFasterThanTheFieldDecaysWithTheMassOverTheDrag) {
  constexpr int steps = 1000;
  for (Scene& scene : scenes()) {
    // Along a lateral axis whose field does not change along it, so that the field's own gradient does no work.
    scene.motion.compression_rate_x = 0.0;
    follow_field(scene, {0.02, 0.0, 0.0});
    const Assembly after = ran(scene, steps)->save();
    const UniformFlow flow = uniform_flow(after.cell, scene.motion);
    double momentum = 0.0, expected = 0.0;
    for (std::size_t i = 0; i < after.size(); ++i) {
      if (after.role[i] != Role::mobile) continue;
      const double mass = sphere_mass(after.radius[i], Material{});
      momentum += mass * (after.velocity[i] - flow.at(after.position[i])).x();
      expected += mass * 0.02 * std::exp(-drag / mass * steps * step);
    }
    // Half-step drag is first order: c dt / 2m = 1e-4 relative.
    EXPECT_NEAR(momentum, expected, 3e-4 * expected) << scene.name;
  }
}

TEST_P(DragContract, IsNoStress) {
  for (Scene& scene : scenes()) {
    follow_field(scene, {0.02, -0.01, 0.03});
    const auto e = ran(scene, 20);
    if (scene.gas.cell.periodic[2] && GetParam().starts_with("liggghts")) continue;  // which tells no stress then
    const CellStress stress = e->cell_stress();
    double left_in = 0.0;  // the stress that the drag would be
    for (const Vector3& force : e->save().force) left_in += force.norm() * length / e->cell().volume();
    for (auto part : {&CellStress::normal, &CellStress::shear, &CellStress::transverse, &CellStress::lateral_x,
                      &CellStress::lateral_y})
      EXPECT_LT(std::abs(stress.*part), rounding() * left_in) << scene.name;
    EXPECT_GT(left_in, 1.0) << scene.name;
  }
}

TEST_P(DragContract, LeavesBagisStressWhatItIsWhileTheCellMoves) {
  auto e = engine();
  e->load(touching_lattice(), settings(0.5));
  e->move({Vector3::Zero(), {0.3, 0.1, -0.05}, 1.0, 0.5});
  e->run(300);
  Assembly now = e->save();
  if (GetParam() == "native-mixed")  // histories capped in float, as engine_contract_test.cpp says
    for (ContactHistory& contact : now.contacts) {
      contact.tangential_spring *= 1.0 + 5e-7;
      contact.rolling_torque *= 1.0 + 5e-7;
    }
  const SlopeStress bagi = slope_stress(bagi_stress(now, evaluate_contact_forces(now, Material{}, step)));
  const CellStress cheap = e->cell_stress();
  const double within = (GetParam() == "native-mixed" ? 1e-6 : 1e-9) * bagi.normal;
  EXPECT_NEAR(cheap.normal, bagi.normal, within);
  EXPECT_NEAR(cheap.shear, bagi.shear, within);
}

TEST_P(DragContract, GoesOnFromASavedState) {
  const BoundaryMotion motion{Vector3::Zero(), {0.3, 0.1, -0.05}, 1.0, 0.5};
  const auto whole = engine(), parts = engine();
  for (Engine* e : {whole.get(), parts.get()}) {
    e->load(touching_lattice(), settings());
    e->move(motion);
  }
  whole->run(200);
  parts->run(100);
  const Assembly middle = parts->save();
  parts->load(middle, settings());
  parts->move(motion);
  parts->run(100);
  const Assembly one = whole->save(), other = parts->save();
  // The native engine promises the same bits.
  const double within = GetParam().starts_with("native") ? 0.0 : 1e-12;
  for (std::size_t i = 0; i < one.size(); ++i)
    EXPECT_LE((one.position[i] - other.position[i]).norm(), within * one.cell.height()) << i;
  EXPECT_LE(std::abs(whole->cell_stress().normal - parts->cell_stress().normal), within * whole->cell_stress().normal);
}

INSTANTIATE_TEST_SUITE_P(Engines, DragContract, testing::ValuesIn(engine_names_of_build()), [](const auto& engine) {
  std::string name = engine.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

}  // namespace
}  // namespace flowslide::drag_contract_test
