// SPDX-License-Identifier: GPL-2.0-or-later
#include "program/metrics_table.hpp"

#include <gtest/gtest.h>

namespace flowslide {
namespace {

TEST(MetricsTable, HasOneRowPerMetric) {
  const std::string table = metrics_table({{"RD.v_max", 0.1}, {"RD.v_max.median", 1e-7}, {"growth", 4}});
  EXPECT_TRUE(table.starts_with("run metric value\n#")) << table;
  EXPECT_TRUE(table.ends_with("its value | \nRD v_max 0.1\nRD v_max.median 1e-07\n- growth 4\n")) << table;
}

TEST(MetricsTable, HasNoRowWithoutMetrics) {
  const std::string table = metrics_table({});
  EXPECT_EQ(table.find('\n', table.rfind('#')), table.size() - 1) << table;
}

}  // namespace
}  // namespace flowslide
