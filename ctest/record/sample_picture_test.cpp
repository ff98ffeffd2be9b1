// SPDX-License-Identifier: GPL-2.0-or-later
#include "record/sample_picture.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <sstream>
#include <stdexcept>

#include "temporary_folder.hpp"

namespace flowslide {
namespace {

constexpr View front{-90.0, 0.0, 0.0, 1};  // x to the right, z up, y away from the viewer

Assembly grains_at(const std::vector<Vector3>& positions) {
  Assembly assembly;
  assembly.resize(positions.size());
  assembly.cell = {Vector3::Zero(), Vector3(1.0, 1.0, 1.0), {true, true, false}};
  assembly.position = positions;
  assembly.radius.assign(positions.size(), 0.1);
  return assembly;
}

TEST(SamplePicture, ProjectsParallelToTheView) {
  const auto grain = grains_at({{0.3, 0.2, 0.6}});
  const auto discs = draw_grains(grain, front);
  ASSERT_EQ(discs.size(), 1);
  EXPECT_NEAR(discs[0].across, 0.3, 1e-15);
  EXPECT_NEAR(discs[0].up, 0.6, 1e-15);
  EXPECT_EQ(discs[0].radius, 0.1);
  const auto from_x = draw_grains(grain, {0.0, 0.0, 0.0, 1});
  EXPECT_NEAR(from_x[0].across, 0.2, 1e-15);
  const auto from_above = draw_grains(grain, {-90.0, 90.0, 0.0, 1});
  EXPECT_NEAR(from_above[0].across, 0.3, 1e-15);
  EXPECT_NEAR(from_above[0].up, 0.2, 1e-15);
}

TEST(SamplePicture, PaintsTheNearGrainLast) {
  auto assembly = grains_at({{0.5, 0.1, 0.5}, {0.55, 0.6, 0.5}, {0.45, 0.3, 0.5}});
  assembly.role = {Role::mobile, Role::bottom_layer, Role::top_layer};
  const auto discs = draw_grains(assembly, front);
  ASSERT_EQ(discs.size(), 3);
  EXPECT_EQ(discs[0].role, Role::bottom_layer);
  EXPECT_EQ(discs[1].role, Role::top_layer);
  EXPECT_EQ(discs[2].role, Role::mobile);
}

TEST(SamplePicture, LeavesOutWhatCannotBeSeen) {
  auto assembly = grains_at({{0.5, 0.1, 0.5}, {0.5, 0.8, 0.5}, {0.5, 0.8, 0.65}});
  assembly.radius[1] = 0.05;
  const auto discs = draw_grains(assembly, front);
  ASSERT_EQ(discs.size(), 2);
  EXPECT_EQ(discs[0].radius, 0.1);
  EXPECT_NEAR(discs[0].up, 0.65, 1e-15);
}

TEST(SamplePicture, ShellsStayInsideTheirGrainAndBrighten) {
  const auto discs = draw_grains(grains_at({{0.3, 0.2, 0.6}}), {-65.0, 20.0, 0.0, 6});
  ASSERT_EQ(discs.size(), 6);
  for (std::size_t i = 1; i < 6; ++i) {
    EXPECT_GT(discs[i].shade, discs[i - 1].shade);
    const double offset = std::hypot(discs[i].across - discs[i - 1].across, discs[i].up - discs[i - 1].up);
    EXPECT_LT(offset + discs[i].radius, discs[i - 1].radius);
  }
  EXPECT_GE(discs.front().shade, 0.0);
  EXPECT_LE(discs.back().shade, 1.0);
}

TEST(SamplePicture, FoldsGrainsIntoTheShearedCell) {
  View view = front;
  EXPECT_NEAR(draw_grains(grains_at({{1.3, 0.2, 0.5}}), view)[0].across, 0.3, 1e-15);
  view.shear_strain = 0.4;  // at half the height the cell spans 0.2 to 1.2
  EXPECT_NEAR(draw_grains(grains_at({{1.3, 0.2, 0.5}}), view)[0].across, 0.3, 1e-15);
  EXPECT_NEAR(draw_grains(grains_at({{0.1, 0.2, 0.5}}), view)[0].across, 1.1, 1e-15);
}

TEST(SamplePicture, WritesOneTableOfDiscsAndEdges) {
  const TemporaryFolder folder;
  auto assembly = grains_at({{0.3, 0.2, 0.6}, {0.7, 0.2, 0.6}});
  assembly.role = {Role::mobile, Role::top_layer};
  write_picture(folder / "picture.dat", assembly, {-65.0, 20.0, 0.0, 3});
  std::istringstream lines(read_file(folder / "picture.dat"));
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, "across up radius shade part");
  std::map<int, int> rows;
  while (std::getline(lines, line)) {
    if (line.empty() || line.starts_with('#')) continue;
    std::istringstream numbers(line);
    double across = 0.0, up = 0.0, radius = 0.0, shade = 0.0;
    int part = -1;
    EXPECT_TRUE(numbers >> across >> up >> radius >> shade >> part) << line;
    EXPECT_EQ(radius > 0.0, part < 3) << line;
    ++rows[part];
  }
  // Shells of each grain; 9 edges in front and 3 behind, two ends each.
  EXPECT_EQ(rows, (std::map<int, int>{{0, 3}, {2, 3}, {3, 18}, {4, 6}}));
}

TEST(SamplePicture, RefusesGrainsWithoutAPlace) {
  EXPECT_THROW(draw_grains(grains_at({{std::nan(""), 0.2, 0.6}}), front), std::invalid_argument);
  EXPECT_THROW(draw_grains(grains_at({{0.3, 0.2, 0.6}}), {0.0, 0.0, 0.0, 0}), std::invalid_argument);
  EXPECT_TRUE(draw_grains(grains_at({}), front).empty());
}

}  // namespace
}  // namespace flowslide
