// SPDX-License-Identifier: GPL-2.0-or-later
#include "scene.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace flowslide::scene_test {
namespace {

constexpr double rounding = 1e-12;

SlidePoint point_of(Scene scene) {
  SlidePoint point;
  if (scene == Scene::element) point.test = ShearTest{};
  if (scene == Scene::trigger) point.settings.loading = ConstantRate{1e4};
  if (scene == Scene::pulse) point.settings.loading = SinePulse{3e3, 2.0};
  return point;
}

double metric(Scene scene, const Series& series, const std::string& name) {
  const SlidePoint point = point_of(scene);
  const Series none;
  const RunMeasures measures = measures_of_rows(series);
  for (const Metric& metric : scene_metrics({point, series, measures, none, Stop::end_time, nullptr}))
    if (metric.name == name) return metric.value;
  ADD_FAILURE() << "no metric " << name;
  return 0.0;
}

/// Rows at strains k/1000 whose shear stress is a parabola with its top of 5000 Pa at 0.43 %, sigma falling evenly.
Series shear_test() {
  Series series = shear_test_series();
  for (int k = 0; k <= 50; ++k) {
    std::array<double, 12> row{};
    row[0] = 1e-3 * k;
    row[1] = 5000.0 - 2e8 * (row[0] - 0.0043) * (row[0] - 0.0043);
    row[2] = 28000.0 * (1.0 - row[0] / 0.025);
    series.append_row(0.1 * k, row);
  }
  return series;
}

TEST(SceneMetrics, FindThePeakBetweenRows) {
  const Series series = shear_test();
  EXPECT_NEAR(metric(Scene::element, series, "peak_shear_stress"), 5000.0, 1e-6);
  EXPECT_NEAR(metric(Scene::element, series, "strain_at_peak"), 0.0043, rounding);
}

TEST(SceneMetrics, FindWhereASampleIsLiquefied) {
  Series series = shear_test();
  EXPECT_NEAR(metric(Scene::element, series, "strain_at_liquefaction"), 0.0225, rounding);
  for (double& normal : series.columns[2].values) normal = 28000.0;
  EXPECT_TRUE(std::isnan(metric(Scene::element, series, "strain_at_liquefaction")));
}

Series slide(double end) {
  Series series = slide_series();
  for (int k = 0; k <= 100; ++k) {
    std::array<double, 17> row{};
    const double time = 0.01 * end * k;
    row[0] = 2.0 * time;                       // x
    row[1] = 3.0 * time;                       // v
    row[2] = time;                             // gamma
    row[4] = 3000.0 - 1e6 * (time - 0.0125) * (time - 0.0125);
    series.append_row(time, row);
  }
  return series;
}

TEST(SceneMetrics, TellWhenASlopeIsUnstableAndHowFastItThenIs) {
  EXPECT_NEAR(metric(Scene::trigger, slide(1.0), "instability_time"), 0.01, rounding);  // of the moments that there are
  EXPECT_NEAR(metric(Scene::trigger, slide(1.0), "velocity_at_half"), 1.5, 1e-9);
  EXPECT_TRUE(std::isnan(metric(Scene::trigger, slide(0.4), "velocity_at_half")));
}

TEST(SceneMetrics, TellHowFastAndFarAPulseGoes) {
  EXPECT_NEAR(metric(Scene::pulse, slide(1.0), "largest_velocity"), 3.0 * 0.95, 1e-9);
  EXPECT_NEAR(metric(Scene::pulse, slide(1.0), "runout"), 2.0, rounding);
  EXPECT_NEAR(metric(Scene::pulse, slide(1.0), "duration"), 1.0, rounding);
}

TEST(Scene, FollowsFromWhatAPointDoes) {
  for (const Scene scene : all_scenes) EXPECT_EQ(scene_of(point_of(scene)), scene);
  EXPECT_EQ(name_of(Scene::trigger), "trigger");
  for (const Scene scene : all_scenes) EXPECT_GE(quantities_of(scene).size(), 2U);
}

}  // namespace
}  // namespace flowslide::scene_test
