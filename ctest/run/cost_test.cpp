// SPDX-License-Identifier: GPL-2.0-or-later
#include "run/cost.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace flowslide {
namespace {

Provenance point_of(double predicted, double spent) {
  Provenance point;
  point.predicted_seconds = predicted;
  point.processor_seconds = spent;
  return point;
}

TEST(Cost, IsSummedOverThePointsThatSayIt) {
  const std::vector<Provenance> points{point_of(60.0, 90.0), Provenance{}, point_of(600.0, 510.0)};
  const Cost cost = cost_of(points);
  EXPECT_EQ(cost.points, 3);
  EXPECT_EQ(cost.recorded, 2);
  EXPECT_EQ(cost.predicted_seconds, 660.0);
  EXPECT_EQ(cost.processor_seconds, 600.0);
  EXPECT_EQ(cost_text(cost),
            "cost: 10 min 00 s of processor time, 11 min 00 s predicted; without 1 of 3 runs, which did not record it");
  EXPECT_EQ(cost_json(cost),
            "{\"points\":3,\"recorded\":2,\"predicted_seconds\":660.0,\"processor_seconds\":600.0}\n");
}

TEST(Cost, IsNotInventedWhenNoPointSaysIt) {
  EXPECT_EQ(cost_text(cost_of(std::vector<Provenance>(2))), "cost: not recorded");
}

}  // namespace
}  // namespace flowslide
