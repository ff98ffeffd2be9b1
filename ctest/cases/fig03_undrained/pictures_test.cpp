// SPDX-License-Identifier: GPL-2.0-or-later
#include "pictures.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "support/touching_lattice.hpp"

namespace flowslide {
namespace {

namespace fs = std::filesystem;

class PicturesTest : public testing::Test {
 protected:
  PicturesTest() { fs::remove_all(folder_); }
  ~PicturesTest() override { fs::remove_all(folder_); }
  /// Its own for each test: they may run side by side.
  const fs::path folder_ = fs::path(testing::TempDir()) /
                           (std::string("pictures_") + testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(PicturesTest, ShowTheSampleBeforeAndAtTheStrainWithFramesBetween) {
  const OutputFolder output = OutputFolder::open(folder_, "fig03_undrained");
  Pictures pictures(0.25);
  for (int row = 0; row <= 50; ++row) pictures.take(0.1 * row, 0.01 * row, touching_lattice(4, 5));
  pictures.write(output, "curve");
  EXPECT_TRUE(fs::exists(folder_ / "fig02_before.dat"));
  EXPECT_TRUE(fs::exists(folder_ / "fig02_during.dat"));
  for (const char* table : {"slices_x", "slices_y", "slices_z", "distances", "contacts"})
    EXPECT_TRUE(fs::exists(folder_ / (std::string("fig02_") + table + ".dat"))) << table;
  std::ifstream file(folder_ / "curve.pvd");
  const std::string collection(std::istreambuf_iterator<char>(file), {});
  for (int frame = 0; frame <= 5; ++frame) {
    EXPECT_TRUE(fs::exists(folder_ / "curve_frames" / ("grains_" + std::to_string(frame) + ".vtp")));
    EXPECT_NE(collection.find("curve_frames/grains_" + std::to_string(frame) + ".vtp"), std::string::npos);
  }
  EXPECT_FALSE(fs::exists(folder_ / "curve_frames" / "grains_6.vtp"));
  EXPECT_NE(collection.find("timestep=\"2.5\""), std::string::npos) << collection;  // 25 % strain is row 25
}

TEST_F(PicturesTest, NoStrainMeansNoFiles) {
  const OutputFolder output = OutputFolder::open(folder_, "fig03_undrained");
  Pictures pictures(std::nullopt);
  pictures.take(0.0, 0.0, touching_lattice(4, 5));
  pictures.write(output, "curve");
  EXPECT_FALSE(fs::exists(folder_ / "fig02_before.dat"));
  EXPECT_FALSE(fs::exists(folder_ / "curve.pvd"));
}

}  // namespace
}  // namespace flowslide
