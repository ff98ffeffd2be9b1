// SPDX-License-Identifier: GPL-2.0-or-later
#include "sample_library/sample_health.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace flowslide {
namespace {

PackingHealth example() {
  PackingHealth health;
  health.axes[0].spread = 0.011;
  health.axes[2].spread = 0.012;
  health.axes[1].seam = -0.004;
  health.axes[1].middle_order = {0.03, 600};
  health.network.mechanical_coordination_number = 4.61;
  health.network.rattler_share = 0.09;
  health.network.fabric_anisotropy = 0.017;
  health.lower_half.normal = 28e3;
  return health;
}

TEST(SampleHealth, EachNumberHasItsNameAndUnit) {
  const std::vector<Metric> metrics = metrics_of(example());
  EXPECT_NO_THROW(check_metrics(metrics));
  EXPECT_EQ(metrics.size(), 27U);
  const auto value = [&](const char* name) {
    return std::find_if(metrics.begin(), metrics.end(), [&](const Metric& m) { return m.name == name; })->value;
  };
  EXPECT_EQ(value("void_ratio_spread_z"), 0.012);
  EXPECT_EQ(value("seam_y"), -0.004);
  EXPECT_EQ(value("middle_order_y"), 0.03);
  EXPECT_EQ(value("lower_half_normal_stress"), 28e3);
  for (const Metric& metric : metrics)
    EXPECT_EQ(metric.units, metric.name.find("stress") == std::string::npos ? "1" : "Pa") << metric.name;
}

}  // namespace
}  // namespace flowslide
