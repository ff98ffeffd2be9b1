// SPDX-License-Identifier: GPL-2.0-or-later
#include "dem/liggghts/steering_fix.hpp"

#include <gtest/gtest.h>

#include <atom.h>
#include <fmt/format.h>
#include <lammps.h>

#include "dem/liggghts/instance.hpp"
#include "dem/liggghts/liggghts_engine.hpp"
#include "support/touching_lattice.hpp"

namespace flowslide {
namespace {

Assembly one_grain(const Vector3& position, const Vector3& velocity) {
  Assembly assembly;
  assembly.cell.upper = {0.02, 0.02, 0.02};
  assembly.resize(1);
  assembly.radius = {3e-3};
  assembly.position = {position};
  assembly.velocity = {velocity};
  return assembly;
}

TEST(SteeringFix, PlanesAreTheFrictionlessWallsOfLiggghts) {
  const EngineSettings settings{Material{}, 2e-6, 0.0};
  LiggghtsEngine engine(testing::TempDir() + "planes.log");
  engine.load(one_grain({0.01, 0.01, 3.001e-3}, {0.01, 0.0, -0.05}), settings);

  LiggghtsInstance reference(testing::TempDir() + "wall.log");
  for (const char* line :
       {"hard_particles yes", "units si", "atom_style granular", "atom_modify map array", "boundary f f f",
        "newton off", "communicate single vel yes", "region box block 0 0.02 0 0.02 -0.005 0.02 units box",
        "create_box 2 box", "neighbor 0.00025 bin",
        "fix y all property/global youngsModulus peratomtype 2e9 2e9",
        "fix p all property/global poissonsRatio peratomtype 0.25 0.25",
        "fix r all property/global coefficientRestitution peratomtypepair 2 0.8 0.8 0.8 0.8",
        "fix f all property/global coefficientFriction peratomtypepair 2 0.5 0 0 0",
        "pair_style gran model hertz tangential history", "pair_coeff * *", "timestep 2e-6",
        "fix wall all wall/gran model hertz tangential history primitive type 2 zplane 0.0",
        "create_atoms 1 single 0.01 0.01 0.003001 units box", "set atom 1 diameter 0.006 density 2650 vx 0.01 vz -0.05",
        "fix integrate all nve/sphere"})
    reference.command(line);
  reference.command("run 0");
  for (int part = 0; part < 10; ++part) {
    engine.run(20);
    reference.command("run 20 pre no post no");
    const LAMMPS_NS::Atom& atom = *reference->atom;
    const Assembly now = engine.save();
    // One contact: the same operations but for the order of a few factors.
    EXPECT_NEAR(now.position[0].z(), atom.x[0][2], 1e-15);
    EXPECT_NEAR(now.velocity[0].z(), atom.v[0][2], 1e-12);
    EXPECT_NEAR(now.velocity[0].x(), atom.v[0][0], 1e-15);
  }
  EXPECT_GT(engine.save().velocity[0].z(), 0.03);  // it has bounced
}

TEST(SteeringFix, AMovingPlanePushesAtItsOwnVelocity) {
  const EngineSettings settings{Material{}, 2e-6, 0.0};
  LiggghtsEngine engine(testing::TempDir() + "planes.log");
  // A plane that moves at 0.05 m/s against a grain at rest acts as a grain at 0.05 m/s against a plane at rest.
  engine.load(one_grain({0.01, 0.01, 3.001e-3}, Vector3::Zero()), settings);
  BoundaryMotion motion;
  motion.bottom_velocity.z() = 0.05;
  engine.move(motion);
  engine.run(200);
  const double pushed = engine.save().velocity[0].z();
  engine.load(one_grain({0.01, 0.01, 3.001e-3}, {0.0, 0.0, -0.05}), settings);
  engine.run(200);
  EXPECT_NEAR(pushed - 0.05, engine.save().velocity[0].z(), 1e-9);
}

TEST(SteeringFix, EveryPlanePushesInwards) {
  const EngineSettings settings{Material{}, 2e-6, 0.0};
  for (int axis = 0; axis < 3; ++axis)
    for (const bool upper : {false, true}) {
      Vector3 position = Vector3::Constant(0.01);
      position[axis] = upper ? 0.02 - 2.99e-3 : 2.99e-3;
      LiggghtsEngine engine(testing::TempDir() + "planes.log");
      engine.load(one_grain(position, Vector3::Zero()), settings);
      engine.run(1);
      const Vector3 force = engine.save().force[0];
      EXPECT_GT(upper ? -force[axis] : force[axis], 0.0) << axis << upper;
      EXPECT_NEAR(force.norm(), std::abs(force[axis]), 1e-15);
    }
}

TEST(SteeringFix, GluedLayersKeepTheirVelocityWhateverPushesThem) {
  LiggghtsEngine engine(testing::TempDir() + "planes.log");
  engine.load(touching_lattice(), {Material{}, 2e-6, 0.0});
  BoundaryMotion motion;
  motion.top_velocity = {0.3, -0.1, 0.01};
  engine.move(motion);
  const Assembly before = engine.save();
  engine.run(100);
  const Assembly after = engine.save();
  for (std::size_t i = 0; i < after.size(); ++i) {
    if (after.role[i] == Role::mobile) continue;
    const Vector3 moved = after.cell.nearest_image(after.position[i] - before.position[i]);
    const Vector3 expected = after.role[i] == Role::top_layer ? Vector3(100 * 2e-6 * motion.top_velocity)
                                                              : Vector3(Vector3::Zero());
    EXPECT_LT((moved - expected).norm(), 1e-15);
    EXPECT_EQ(after.spin[i], Vector3::Zero());
  }
}

TEST(SteeringFix, APeriodicAxisCarriesGrainsAffinely) {
  LiggghtsEngine engine(testing::TempDir() + "planes.log");
  Assembly gas = one_grain({0.004, 0.01, 0.01}, Vector3::Zero());
  gas.cell.periodic = {true, true, false};
  engine.load(gas, {Material{}, 2e-6, 0.0});
  BoundaryMotion motion;
  motion.compression_rate_x = 2.0;
  engine.move(motion);
  engine.run(50);
  const Assembly after = engine.save();
  EXPECT_NEAR((after.position[0].x() - 0.01) / (0.004 - 0.01), std::pow(1.0 - 2.0 * 2e-6, 50), 1e-12);
  EXPECT_EQ(after.velocity[0], Vector3::Zero());
}

}  // namespace
}  // namespace flowslide
