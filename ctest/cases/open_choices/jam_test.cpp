// SPDX-License-Identifier: GPL-2.0-or-later
#include "jam.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <utility>

namespace flowslide {
namespace {

constexpr double scale = 1000.0;  // sigma_0, Pa

/// Rows (strain, tau); sigma is twice tau.
Series rows(const std::vector<std::pair<double, double>>& points) {
  Series series;
  series.columns = {{"shear_strain", "", "1", "", "", {}}, {"shear_stress", "", "Pa", "", "", {}},
                    {"normal_stress", "", "Pa", "", "", {}}};
  for (const auto& [strain, shear] : points) series.append_row(strain, std::array{strain, shear, 2.0 * shear});
  return series;
}

TEST(Jam, IsWhereTauExceedsTheLevelToTheEnd) {
  const Jam jam = jam_of(rows({{0.0, 400}, {0.1, 1}, {0.5, 150}, {0.6, 2}, {1.0, 20}, {1.5, 120}, {2.0, 300}}), scale,
                         false);
  EXPECT_EQ(jam.liquefied_strain, 0.1);
  EXPECT_EQ(jam.strain_1, 1.0);
  EXPECT_EQ(jam.strain_10, 1.5);
  EXPECT_TRUE(jam.jams());
  EXPECT_EQ(jam.largest_burst, 150.0);  // came and went
}

TEST(Jam, IsNoneWhileALateRiseHasNotLasted) {
  const Series late = rows({{0.0, 400}, {0.1, 1}, {2.8, 300}, {3.0, 400}});
  EXPECT_FALSE(jam_of(late, scale, false).jams());
  EXPECT_EQ(jam_of(late, scale, false).largest_burst, 400.0);
  EXPECT_TRUE(jam_of(late, scale, true).jams());  // the test was ended by its stress
}

TEST(Jam, OfASampleThatNeverLiquefiesIsFromTheStart) {
  const Jam jam = jam_of(rows({{0.0, 400}, {1.0, 300}, {2.0, 500}}), scale, false);
  EXPECT_FALSE(jam.liquefies());
  EXPECT_EQ(jam.strain_10, 0.0);
  EXPECT_EQ(jam.largest_burst, 0.0);
}

TEST(Jam, MetricsLeaveOutStrainsThatWereNotReached) {
  const auto metrics = metrics_of(jam_of(rows({{0.0, 400}, {0.1, 1}, {3.0, 2}}), scale, false), scale);
  ASSERT_EQ(metrics.size(), 3u);
  EXPECT_EQ(metrics[0].value, 0.0);
  EXPECT_EQ(metrics[1].name, "liquefied_strain");
  EXPECT_EQ(metrics[2].name, "largest_burst");
  EXPECT_EQ(metrics[2].value, 2e-3);
}

}  // namespace
}  // namespace flowslide
