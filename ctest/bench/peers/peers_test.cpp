// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "dem/liggghts/commands.hpp"
#include "grains/contact_forces.hpp"
#include "grains/stress.hpp"
#include "peers/first_forces.hpp"
#include "peers/lammps_input.hpp"
#include "peers/peer_codes.hpp"
#include "peers/peer_table.hpp"
#include "record/temporary_folder.hpp"
#include "support/touching_lattice.hpp"

namespace flowslide {
namespace {

constexpr double rounding = 1e-9;  // of sums in another order, relative to the largest force

PeerSample lattice() {
  PeerSample sample;
  sample.assembly = touching_lattice();
  sample.top_velocity = 1e-3;
  return with_layers_moving(std::move(sample));
}

/// Without motion all laws have the same forces: those of Hertz.
PeerSample at_rest() {
  PeerSample sample = lattice();
  sample.top_velocity = 0.0;
  for (auto* vectors : {&sample.assembly.velocity, &sample.assembly.spin})
    for (Vector3& vector : *vectors) vector.setZero();
  return sample;
}

/// The words of the lines of a section of a data file.
std::vector<std::vector<double>> section(const std::string& data, const std::string& title) {
  std::istringstream lines(data.substr(data.find("\n" + title)));
  std::string line;
  for (int skipped = 0; skipped < 3; ++skipped) std::getline(lines, line);
  std::vector<std::vector<double>> rows;
  while (std::getline(lines, line) && !line.empty()) {
    std::istringstream words(line);
    rows.emplace_back();
    for (double value = 0.0; words >> value;) rows.back().push_back(value);
  }
  return rows;
}

TEST(LammpsData, HasTheGrainsOfTheSampleWithinItsBox) {
  PeerSample sample = lattice();
  sample.assembly.position[40].x() += 2.0 * sample.assembly.cell.lengths().x();  // an image of the same grain
  const Assembly& grains = sample.assembly;
  const std::string data = lammps_data(sample);
  EXPECT_NE(data.find("\n" + std::to_string(grains.size()) + " atoms\n"), std::string::npos);
  const auto atoms = section(data, "Atoms"), velocities = section(data, "Velocities");
  ASSERT_EQ(atoms.size(), grains.size());
  ASSERT_EQ(velocities.size(), grains.size());
  for (std::size_t i = 0; i < grains.size(); ++i) {
    ASSERT_EQ(atoms[i].size(), 7u);
    EXPECT_EQ(atoms[i][0], static_cast<double>(i + 1));
    EXPECT_EQ(atoms[i][1], atom_type(grains.role[i]));
    EXPECT_EQ(atoms[i][2], 2.0 * grains.radius[i]);
    EXPECT_EQ(atoms[i][3], sample.material.density);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_GE(atoms[i][4 + axis], grains.cell.lower[axis]);
      EXPECT_LE(atoms[i][4 + axis], grains.cell.upper[axis]);
      EXPECT_EQ(velocities[i][1 + axis], grains.velocity[i][axis]);
      EXPECT_EQ(velocities[i][4 + axis], grains.spin[i][axis]);
    }
  }
}

TEST(SampleTable, HasALineForEachGrain) {
  const PeerSample sample = lattice();
  std::istringstream lines(sample_table(sample));
  std::size_t grain = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("#")) continue;
    std::istringstream words(line);
    int role = -1;
    double radius = 0.0;
    words >> role >> radius;
    EXPECT_EQ(role, static_cast<int>(sample.assembly.role[grain]));
    EXPECT_EQ(radius, sample.assembly.radius[grain]);
    ++grain;
  }
  EXPECT_EQ(grain, sample.assembly.size());
}

TEST(TsujiRestitution, GivesTheDashpotOfThisProject) {
  const PairConstants pair = pair_constants(Material{}, 3e-3, 3e-3);
  const double e = tsuji_restitution(pair);
  const double alpha = 1.2728 - 4.2783 * e + 11.087 * e * e - 22.348 * std::pow(e, 3) + 27.467 * std::pow(e, 4) -
                       18.022 * std::pow(e, 5) + 4.8218 * std::pow(e, 6);
  EXPECT_NEAR(alpha, -std::sqrt(5.0) * pair.damping, 1e-12);
}

TEST(FirstForces, OfTheLawOfThisProjectAreThoseOfEvaluateContactForces) {
  const PeerSample sample = lattice();
  EXPECT_LT(force_error(first_forces(sample, {}), first_forces_of_this_project(sample)), rounding);
}

TEST(FirstForces, DifferBetweenLawsOnlyInMotion) {
  const FirstStepLaw other{true, true, true, true, 1e6, 1e6};
  EXPECT_LT(force_error(first_forces(at_rest(), other), first_forces_of_this_project(at_rest())), rounding);
  EXPECT_GT(force_error(first_forces(lattice(), other), first_forces_of_this_project(lattice())), 1e-6);
}

TEST(SectionStress, IsThatOfBagi) {
  const PeerSample sample = lattice();
  Assembly grains = sample.assembly;
  ContactForces forces = evaluate_contact_forces(grains, sample.material, 0.0);
  const SectionStress stress = section_stress(grains, sum_on_grains(forces, grains.size()).force);
  const SlopeStress bagi = slope_stress(bagi_stress(grains, forces));
  EXPECT_NEAR(stress.normal, bagi.normal, 1e-9 * bagi.normal);
  EXPECT_NEAR(stress.shear, bagi.shear, 1e-9 * bagi.normal);
}

TEST(TimesSlower, IsTheMedianOfTheTurns) {
  PeerCode native, peer;
  native.name = "native";
  const std::vector<PeerRow> rows{{&native, {}, {10.0, 20.0, 30.0}}, {&peer, {}, {5.0, 2.0, 10.0}}};
  EXPECT_EQ(times_slower(rows[1], "native", rows), 3.0);
  EXPECT_EQ(times_slower(rows[1], "native-mixed", rows), 0.0);
}

/// Steps every code that is installed, from a state at rest and from one in motion.
class Peers : public testing::TestWithParam<std::string> {};

TEST_P(Peers, BeginWithTheForcesOfTheirLaw) {
  std::vector<std::string> left_out;
  const std::vector<PeerCode> codes = peer_codes(2, left_out);
  const auto code = std::find_if(codes.begin(), codes.end(), [](const PeerCode& c) { return c.name == GetParam(); });
  if (code == codes.end()) GTEST_SKIP() << GetParam() << " is not installed (packages-peers.txt)";
  const TemporaryFolder room;
  for (const PeerSample& sample : {at_rest(), lattice()}) {
    const PeerScene scene{"lattice", sample, room.path(), 1};
    const PeerSteps steps{1, 1};
    code->write(scene, steps);
    EXPECT_GT(code->run(scene, steps), 0.0);
    const FirstState first = code->first_state(scene);
    EXPECT_TRUE(first.agrees()) << "error " << first.error << ", sigma " << first.found.normal << ", expected "
                                << first.expected.normal;
    if (sample.top_velocity == 0.0) {
      EXPECT_NEAR(first.found.normal, first.ours.normal, 1e-5 * first.ours.normal);
      EXPECT_NEAR(first.found.shear, first.ours.shear, 1e-5 * first.ours.normal);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, Peers,
                         testing::Values("native", "native-no-rolling", "lammps-granular", "lammps-hertz", "yade"));
INSTANTIATE_TEST_SUITE_P(Liggghts, Peers, testing::Values("liggghts"));

}  // namespace
}  // namespace flowslide
