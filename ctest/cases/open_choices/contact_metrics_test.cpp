// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact_metrics.hpp"

#include <gtest/gtest.h>

#include <map>
#include <string>

#include "sample/stable_time_step.hpp"

namespace flowslide {
namespace {

/// Three grains in a row along z: the lower one glued, overlaps of 2e-5 and 1e-6 m.
Assembly row_of_three() {
  Assembly grains;
  grains.cell.upper = {0.1, 0.1, 0.1};
  grains.resize(3);
  grains.radius = {3e-3, 3e-3, 3e-3};
  for (int i = 0; i < 3; ++i) grains.position[i] = Vector3(0.05, 0.05, 0.02 + 6e-3 * i);
  grains.position[1].z() -= 2e-5;
  grains.position[2].z() -= 2e-5 + 1e-6;
  grains.role[0] = Role::bottom_layer;
  return grains;
}

TEST(ContactMetrics, TellTheOverlapsOfAllAndOfMobileGrains) {
  const Assembly grains = row_of_three();
  std::map<std::string, double> values;
  for (const Metric& metric : contact_metrics(grains, Material{}, 1e-6)) values[metric.name] = metric.value;
  EXPECT_NEAR(values.at("largest_overlap"), 2e-5, 1e-15);
  EXPECT_NEAR(values.at("median_overlap"), 2e-5, 1e-15);
  EXPECT_NEAR(values.at("largest_free_overlap"), 1e-6, 1e-15);
  EXPECT_EQ(values.at("stable_time_step"), stable_time_step(grains, Material{}, 1e-6));
}

TEST(ContactMetrics, LeaveOutWhatThereIsNot) {
  Assembly apart = row_of_three();
  for (double& radius : apart.radius) radius *= 0.5;
  EXPECT_TRUE(contact_metrics(apart, Material{}, 1e-6).empty());
}

}  // namespace
}  // namespace flowslide
