// SPDX-License-Identifier: GPL-2.0-or-later
#include "sample/health.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "grains/measures.hpp"
#include "grains/time_step_share.hpp"
#include "sample/failure.hpp"
#include "support/touching_lattice.hpp"

namespace flowslide {
namespace {

/// An engine that returns prescribed values.
class Puppet : public Engine {
 public:
  void load(const Assembly&, const EngineSettings&) override {}
  Assembly save() const override { return {}; }
  void set(const EngineSettings&) override {}
  const EngineSettings& settings() const override { return settings_; }
  void move(const BoundaryMotion&) override {}
  void run(std::int64_t) override {}
  CellStress cell_stress() const override { return {}; }
  Cell cell() const override { return {}; }
  std::uint64_t count_grains() const override { return 99; }
  std::string name() const override { return "puppet"; }
  std::string version() const override { return "1"; }

 private:
  EngineSettings settings_;
};

TEST(Health, TimeStepsUpTo065RayleighTimesPass) {
  const Material material;
  const double rayleigh = rayleigh_time(2.5e-3, material);
  EXPECT_NO_THROW(validate_time_step(0.649 * rayleigh, 2.5e-3, material));
  EXPECT_THROW(validate_time_step(0.651 * rayleigh, 2.5e-3, material), std::invalid_argument);
  EXPECT_THROW(validate_time_step(0.0, 2.5e-3, material), std::invalid_argument);
  EXPECT_THROW(validate_time_step(-1e-6, 2.5e-3, material), std::invalid_argument);
}

TEST(Health, AMissingGrainStopsTheRun) {
  EXPECT_NO_THROW(check_exchange(Puppet{}, {}, 99));
  EXPECT_THROW(check_exchange(Puppet{}, {}, 100), NumericalFailure);
}

TEST(Health, AStressThatIsNotANumberStopsTheRun) {
  CellStress stress;
  stress.lateral_y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(check_exchange(Puppet{}, stress, 99), NumericalFailure);
  stress = {};
  stress.shear = std::numeric_limits<double>::infinity();
  EXPECT_THROW(check_exchange(Puppet{}, stress, 99), NumericalFailure);
}

TEST(Health, AnOverlapAboveFivePercentStopsTheRun) {
  Assembly assembly = touching_lattice(4, 5);
  assembly.contacts = {{0, 1, Vector3::Zero(), Vector3::Zero()}};
  const double distance = assembly.radius[0] + assembly.radius[1];
  const double smaller = 2.0 * std::min(assembly.radius[0], assembly.radius[1]);
  assembly.position[1] = assembly.position[0] + Vector3(distance - 0.049 * smaller, 0.0, 0.0);
  EXPECT_NO_THROW(check_assembly(assembly));
  assembly.position[1] = assembly.position[0] + Vector3(distance - 0.051 * smaller, 0.0, 0.0);
  EXPECT_THROW(check_assembly(assembly), NumericalFailure);
}

TEST(Health, ATimeStepTooLongForTheContactsStopsTheRun) {
  const Assembly assembly = touching_lattice(4, 5);
  const Material material;
  double step = 1e-5;
  for (int i = 0; i < 40; ++i) step /= std::sqrt(time_step_share(assembly, material, step));
  EXPECT_NO_THROW(check_contact_time_step(assembly, material, 0.99 * step));
  EXPECT_THROW(check_contact_time_step(assembly, material, 1.01 * step), NumericalFailure);
}

TEST(Health, APositionThatIsNotANumberStopsTheRun) {
  Assembly assembly = touching_lattice(4, 5);
  EXPECT_NO_THROW(check_assembly(assembly));
  assembly.spin[3].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(check_assembly(assembly), NumericalFailure);
}

TEST(Health, KineticNumberIsTheMeanEnergyOverPressureTimesVolume) {
  Assembly pair;
  pair.resize(3);
  pair.radius = {3e-3, 3e-3, 3e-3};
  pair.velocity[0] = {0.02, 0.0, 0.0};
  pair.role[2] = Role::top_layer;
  pair.velocity[2] = {100.0, 0.0, 0.0};  // a glued grain does not count
  const double mass = 2650.0 * 4.0 / 3.0 * 3.14159265358979323846 * 27e-9;
  EXPECT_NEAR(kinetic_number(pair, Material{}, 1e4), 0.5 * (0.5 * mass * 4e-4) / (1e4 * 216e-9), 1e-15);
}

}  // namespace
}  // namespace flowslide
