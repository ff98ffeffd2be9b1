// SPDX-License-Identifier: GPL-2.0-or-later
#include "dem/liggghts/liggghts_engine.hpp"

#include <gtest/gtest.h>
#include <mpi.h>
#include <stdlib.h>

#include <cmath>
#include <cstdlib>
#include <memory>
#include <string>

#include "process/mpi_session.hpp"
#include "support/touching_lattice.hpp"

namespace flowslide {
namespace {

/// Two grains that touch, part and touch again within one neighbour list.
Assembly pair(double gap) {
  Assembly assembly;
  assembly.cell.upper = {0.05, 0.05, 0.05};
  assembly.cell.periodic = {true, true, false};
  assembly.resize(2);
  assembly.radius = {3e-3, 3e-3};
  assembly.position = {{0.02, 0.025, 0.025}, {0.026 + gap, 0.025, 0.025}};
  return assembly;
}

TEST(LiggghtsEngine, ForgetsTheHistoryOfAPairThatSeparates) {
  LiggghtsEngine engine(testing::TempDir() + "separation.log");
  Assembly assembly = pair(-2e-6);
  assembly.contacts = {{0, 1, {0.0, 1e-7, 0.0}, {0.0, 0.0, 1e-9}}};
  // They part at 0.5 m/s and come back: without a new list the stale spring would act again.
  assembly.velocity[1].x() = 0.5;
  const EngineSettings settings{Material{}, 1e-6, 0.0};
  engine.load(assembly, settings);
  engine.run(10);
  ASSERT_TRUE(engine.save().contacts.empty());
  Assembly apart = engine.save();
  ASSERT_LT(apart.position[1].x() - apart.position[0].x(), 6e-3 + 30e-6);  // well within the list and the factor
  BoundaryMotion still;
  engine.move(still);
  // Bring them back through the periodic cell's affine motion, which leaves velocities and lists alone.
  BoundaryMotion back;
  back.compression_rate_x = 4000.0;
  engine.move(back);
  engine.run(1);
  engine.move(still);
  const auto contacts = engine.save().contacts;
  ASSERT_EQ(contacts.size(), 1u);
  // One step of new sliding, against the 1e-7 m that it had.
  EXPECT_LT(contacts[0].tangential_spring.norm(), 1e-8);
}

/// tau of a lattice after some steps with this velocity of its top, Pa.
double sheared(LiggghtsEngine& engine, double velocity) {
  engine.load(touching_lattice(), {Material{}, 2e-6, 0.0});
  BoundaryMotion motion;
  motion.top_velocity.x() = velocity;
  engine.move(motion);
  engine.run(100);
  return engine.cell_stress().shear;
}

// Run in one process, and again on two MPI ranks (dem/liggghts.two_ranks).
TEST(LiggghtsEngineRanks, DivideASampleOrHaveOneEach) {
  ensure_mpi();
  const int rank = mpi_rank();
  const auto log = [&](const std::string& name) { return testing::TempDir() + name + std::to_string(rank) + ".log"; };
  LiggghtsEngine together(log("together"), SeparatedHistory::cleared, MPI_COMM_WORLD), own(log("own"));
  double expected = 0.0;
  for (int other = 0; other < mpi_ranks(); ++other)
    if (const double shear = sheared(together, 0.1 * (other + 1)); other == rank) expected = shear;
  const double found = sheared(own, 0.1 * (rank + 1));
  EXPECT_NEAR(found, expected, 1e-9 * std::abs(expected));  // rounding: the ranks sum in another order
  MPI_Comm part = MPI_COMM_NULL;
  MPI_Comm_split(MPI_COMM_WORLD, rank, 0, &part);
  {
    LiggghtsEngine of_part(log("part"), SeparatedHistory::cleared, part);
    EXPECT_EQ(sheared(of_part, 0.1 * (rank + 1)), found);
    EXPECT_EQ(sheared(own, 0.1 * (rank + 1)), found);
  }
  MPI_Comm_free(&part);
}

TEST(LiggghtsEngineRanks, AnErrorOfOneSampleLeavesTheOthers) {
  ensure_mpi();
  LiggghtsEngine together(testing::TempDir() + "together.log", SeparatedHistory::cleared, MPI_COMM_WORLD);
  const double expected = sheared(together, 0.1);
  if (mpi_rank() == 0) {
    LiggghtsInstance broken(testing::TempDir() + "broken.log");
    EXPECT_THROW(broken.command("unknown_command"), EngineError);
  }
  EXPECT_EQ(sheared(together, 0.1), expected);
}

TEST(LiggghtsEngineDeathTest, MayOutliveTheMpiOfItsHost) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");  // a process of its own, in which MPI is not started
  const auto host = [] {
    ::setenv("OMPI_MCA_plm", "isolated", 0);  // see mpi_session.cpp
    MPI_Init(nullptr, nullptr);
    auto engine = std::make_unique<LiggghtsEngine>(testing::TempDir() + "host.log");
    auto other = std::make_unique<LiggghtsEngine>(testing::TempDir() + "other_host.log");
    sheared(*engine, 0.1);
    sheared(*other, 0.1);
    other.reset();  // one simulation is unused, one in use
    MPI_Finalize();
    engine.reset();
    std::exit(0);
  };
  EXPECT_EXIT(host(), testing::ExitedWithCode(0), "^$");
}

TEST(LiggghtsEngine, RefusesAGrainOutsideTheCell) {
  Assembly assembly = pair(1e-3);
  assembly.position[0].z() = 0.5;
  LiggghtsEngine engine(testing::TempDir() + "outside.log");
  try {
    engine.load(assembly, {});
    FAIL() << "a grain half a metre above the cell";
  } catch (const EngineError& error) {
    EXPECT_NE(std::string(error.what()).find("1 of 2 grains"), std::string::npos) << error.what();
  }
}

TEST(LiggghtsEngine, SavesALostGrainAsAnError) {
  Assembly assembly = pair(1e-3);
  assembly.velocity[0].z() = 1e5;
  LiggghtsEngine engine(testing::TempDir() + "lost.log");
  engine.load(assembly, {Material{}, 1e-6, 0.0});
  engine.run(3);
  EXPECT_THROW(engine.save(), EngineError);
}

TEST(LiggghtsEngine, KnowsItsVersion) {
  LiggghtsEngine engine(testing::TempDir() + "version.log");
  EXPECT_NE(engine.version().find("3.8"), std::string::npos) << engine.version();
}

}  // namespace
}  // namespace flowslide
