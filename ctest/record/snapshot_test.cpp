// SPDX-License-Identifier: GPL-2.0-or-later
#include "record/snapshot.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <set>
#include <stdexcept>
#include <utility>

#include "example.hpp"
#include "temporary_folder.hpp"

namespace flowslide {
namespace {

/// The values of the array `name` of a file, as T: what a VTK reader does.
template <typename T>
std::vector<T> values_of(const std::string& text, const std::string& name) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const auto array = text.find("Name=\"" + name + "\"");
  const auto begin = text.find('>', array) + 1, end = text.find('<', begin);
  std::string bytes;
  unsigned bits = 0, count = 0;
  for (const char c : text.substr(begin, end - begin)) {
    if (c == '=') break;
    bits = bits << 6 | static_cast<unsigned>(digits.find(c));
    if (count += 6; count >= 8) bytes += static_cast<char>(bits >> (count -= 8) & 255);
  }
  std::uint64_t size = 0;
  std::memcpy(&size, bytes.data(), sizeof size);
  EXPECT_EQ(bytes.size(), sizeof size + size) << name;
  std::vector<T> values(size / sizeof(T));
  std::memcpy(values.data(), bytes.data() + sizeof size, size);
  return values;
}

TEST(Snapshot, HoldsTheGrains) {
  const TemporaryFolder folder;
  const auto assembly = example_assembly(40);
  write_grains(folder / "grains.vtp", assembly);
  const auto text = read_file(folder / "grains.vtp");
  EXPECT_NE(text.find("NumberOfPoints=\"40\" NumberOfVerts=\"40\""), std::string::npos);
  const auto points = values_of<float>(text, "Points"), velocity = values_of<float>(text, "velocity");
  ASSERT_EQ(points.size(), 120);
  for (std::size_t i = 0; i < 40; ++i) {
    const auto place = folded(assembly.cell, assembly.position[i]);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(points[3 * i + static_cast<std::size_t>(axis)], static_cast<float>(place[axis]));
      EXPECT_EQ(velocity[3 * i + static_cast<std::size_t>(axis)], static_cast<float>(assembly.velocity[i][axis]));
    }
  }
  EXPECT_EQ(values_of<float>(text, "diameter")[7], static_cast<float>(2.0 * assembly.radius[7]));
  EXPECT_EQ(values_of<float>(text, "spin")[4], static_cast<float>(assembly.spin[1].y()));
  EXPECT_EQ(values_of<std::uint8_t>(text, "role")[5], 2);
  EXPECT_EQ(values_of<std::int64_t>(text, "connectivity")[39], 39);
  EXPECT_EQ(values_of<std::int64_t>(text, "offsets")[39], 40);
}

TEST(Snapshot, FoldsPeriodicAxesOnly) {
  const Cell cell{Vector3(-0.1, -0.2, 0.0), Vector3(0.3, 0.2, 0.5), {true, true, false}};
  const auto place = folded(cell, Vector3(0.5, -1.0, 0.7));
  EXPECT_NEAR(place.x(), 0.1, 1e-15);
  EXPECT_NEAR(place.y(), -0.2, 1e-15);
  EXPECT_EQ(place.z(), 0.7);
  EXPECT_EQ(folded(cell, Vector3(0.0, 0.1, 0.2)), Vector3(0.0, 0.1, 0.2));
}

TEST(Snapshot, DrawsTwelveDifferentEdges) {
  const auto cell = example_assembly(0).cell;
  const auto edges = cell_edges(cell);
  ASSERT_EQ(edges.size(), 24);
  std::set<std::pair<std::vector<double>, std::vector<double>>> different;
  double length = 0.0;
  for (std::size_t i = 0; i < 24; i += 2) {
    different.insert({{edges[i].begin(), edges[i].end()}, {edges[i + 1].begin(), edges[i + 1].end()}});
    EXPECT_EQ((edges[i + 1].array() != edges[i].array()).count(), 1);
    length += (edges[i + 1] - edges[i]).norm();
  }
  EXPECT_EQ(different.size(), 12);
  EXPECT_NEAR(length, 4.0 * cell.lengths().sum(), 1e-15);
  const TemporaryFolder folder;
  write_cell(folder / "cell.vtp", cell);
  const auto text = read_file(folder / "cell.vtp");
  EXPECT_NE(text.find("NumberOfPoints=\"24\" NumberOfLines=\"12\""), std::string::npos);
  EXPECT_EQ(values_of<std::int64_t>(text, "offsets")[11], 24);
}

TEST(Snapshot, CollectsFramesInTime) {
  const TemporaryFolder folder;
  const std::vector<Frame> frames{{0.0, "a.vtp", 0}, {0.1, "b&\"<.vtp", 1}};
  write_collection(folder / "run.pvd", frames);
  const auto text = read_file(folder / "run.pvd");
  EXPECT_NE(text.find("<DataSet timestep=\"0\" part=\"0\" file=\"a.vtp\"/>"), std::string::npos) << text;
  EXPECT_NE(text.find("<DataSet timestep=\"0.1\" part=\"1\" file=\"b&amp;&quot;&lt;.vtp\"/>"), std::string::npos)
      << text;
  EXPECT_THROW(write_collection(folder / "bad.pvd", std::vector<Frame>{{std::nan(""), "a.vtp", 0}}),
               std::invalid_argument);
  EXPECT_EQ(folder.entries(), 1);
}

}  // namespace
}  // namespace flowslide
