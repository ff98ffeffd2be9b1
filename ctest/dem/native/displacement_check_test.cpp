// SPDX-License-Identifier: GPL-2.0-or-later
#include "dem/native/displacement_check.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace flowslide::native {
namespace {

constexpr double far = 1.0;  // m, more than any allowance

/// Three grains on a line, watched with allowances of 10, 20 and 30 um.
struct Checked {
  Checked() {
    for (int i = 0; i < 3; ++i) {
      bodies[static_cast<std::size_t>(i)] = {};
      bodies[static_cast<std::size_t>(i)].position[2] = 0.01 * i;
    }
    check.start(all, bodies, {1e-5, 2e-5, 3e-5});
  }
  double measure() {
    return check.measure(passes<double>(instruction_sets().back()).slack,
                         {all.begin, all.end, kick.data(), kick.data(), bodies.data(), bodies.data(), loads.data()});
  }
  /// Number of steps until the list must be built anew, and how many of them asked for a measurement.
  std::pair<int, int> steps(double largest_growth, double measured, bool compressed = false) {
    int count = 0, asked = 0;
    do {
      asked += check.measures();
      ++count;
    } while (!check.advance(largest_growth, measured, 0.0, compressed) && count < 1000);
    return {count, asked};
  }

  const GrainRange all{0, 3};
  std::vector<Body<double>> bodies = std::vector<Body<double>>(3);
  std::vector<Load<double>> loads = std::vector<Load<double>>(3);
  const std::vector<double> kick = std::vector<double>(3, 1.0);
  DisplacementCheck<double> check;
};

TEST(DisplacementCheck, MeasuresWhatIsLeftBesideTheMeanFlow) {
  Checked grains;
  EXPECT_EQ(grains.measure(), 1e-5);
  MeanFlow flow{};
  flow.base[0] = 3.0;
  flow.slope[0] = 200.0;
  flow.origin = 0.005;
  for (int step = 0; step < 10; ++step) grains.check.follow(flow, 1e-5);
  for (Body<double>& body : grains.bodies) body.position[0] += 1e-4 * (3.0 + 200.0 * (body.position[2] - 0.005));
  EXPECT_NEAR(grains.measure(), 1e-5, 1e-18);  // coordinates of 0.5 mm are rounded
  grains.bodies[2].position[1] += 2.5e-5;
  EXPECT_NEAR(grains.measure(), 5e-6, 1e-18);
  grains.bodies[2].position[1] -= 0.04;  // folded
  grains.check.carry(2, 1, -0.04);
  EXPECT_NEAR(grains.measure(), 5e-6, 1e-17);
}

TEST(DisplacementCheck, FollowsAGrainThatIsFoldedInAShearedCell) {
  Checked grains;
  MeanFlow flow{};
  flow.slope[0] = 200.0;
  flow.origin = 0.01;
  Cell cell;
  cell.upper.z() = 0.025;
  cell.shear_offset = 0.003;
  for (int step = 0; step < 10; ++step) {
    grains.check.follow(flow, 1e-5);
    cell.shear_offset += 1e-5 * 200.0 * cell.height();
    for (Body<double>& body : grains.bodies) body.position[0] += 1e-5 * 200.0 * (body.position[2] - 0.01);
  }
  EXPECT_NEAR(grains.measure(), 1e-5, 1e-18);
  grains.bodies[0].position[2] += 0.025;  // the image above, which is further by the offset of now
  grains.bodies[0].position[0] += cell.shear_offset;
  grains.check.carry(0, 2, 0.025);
  grains.check.cross_the_shear(0, 1, cell);
  EXPECT_NEAR(grains.measure(), 1e-5, 1e-17);
  grains.check.follow(flow, 1e-5);
  for (Body<double>& body : grains.bodies) body.position[0] += 1e-5 * 200.0 * (body.position[2] - 0.01);
  EXPECT_NEAR(grains.measure(), 1e-5, 1e-17);
}

TEST(DisplacementCheck, AsksForAMeasurementWhenTheBoundIsNearlyUsedUp) {
  Checked grains;
  // The bound grows by 1 um per step: of 10 um, 2 um are left after 8 steps. Later steps need measured deviations.
  for (int step = 0; step < 9; ++step) {
    EXPECT_FALSE(grains.check.measures()) << step;
    EXPECT_FALSE(grains.check.advance(1e-6, far, 0.0, false));
  }
  EXPECT_TRUE(grains.check.measures());
  EXPECT_FALSE(grains.check.advance(1e-6, 9e-6, 0.0, false));
  EXPECT_FALSE(grains.check.measures());
  EXPECT_EQ(grains.check.age(), 10);
  const auto [steps, asked] = grains.steps(1e-6, 3.9e-6);
  EXPECT_EQ(asked, 1);  // of 3.9 um: not worth another
  EXPECT_EQ(steps, 9);
}

TEST(DisplacementCheck, TakesOffWhatTheFlowDoesBetweenTwoGrains) {
  Checked grains;
  MeanFlow flow{};
  flow.slope[0] = 1.0;
  for (int step = 0; step < 9; ++step) {
    grains.check.follow(flow, 1e-3);
    grains.check.advance(1e-6, far, 0.01, false);
  }
  ASSERT_TRUE(grains.check.measures());
  // Two grains 0.01 m apart have parted by 9e-5 m, half of it each.
  EXPECT_TRUE(grains.check.advance(1e-6, 4.5e-5, 0.01, false));
}

TEST(DisplacementCheck, GoesByTheBoundAloneOnceGrainsWereCarriedSidewards) {
  Checked grains;
  const auto [steps, asked] = grains.steps(1.01e-6, far, true);
  EXPECT_EQ(steps, 10);
  EXPECT_EQ(asked, 0);
}

}  // namespace
}  // namespace flowslide::native
