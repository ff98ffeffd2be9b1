// SPDX-License-Identifier: GPL-2.0-or-later
#include "record/health_line.hpp"

#include <gtest/gtest.h>

namespace flowslide {
namespace {

TEST(HealthLine, HoldsTheLargestOfTheThreeAxes) {
  std::vector<Metric> metrics{{"void_ratio_spread_x", 0.011, "1", ""},
                              {"void_ratio_spread_z", 0.012, "1", ""},
                              {"seam_y", -0.004, "1", ""},
                              {"middle_order_y", 0.03, "1", ""},
                              {"mechanical_coordination_number", 4.61, "1", ""},
                              {"rattler_share", 0.09, "1", ""},
                              {"fabric_anisotropy", 0.017, "1", ""}};
  EXPECT_EQ(health_line(metrics), "");  // no void ratio: not a sample of grains
  metrics.push_back({"initial_void_ratio", 0.7823, "1", ""});
  metrics.push_back({"initial_probe_void_ratio", 0.767, "1", ""});
  EXPECT_EQ(health_line(metrics),
            "e0 0.7823 (probe 0.7670), slices +-0.012, seam 0.004, order 0.030, contacts 4.61, rattlers 9.0 %, fabric "
            "0.017");
}

}  // namespace
}  // namespace flowslide
