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
  /// A folder for each test, because tests may run in parallel.
  const fs::path folder_ = fs::path(testing::TempDir()) /
                           (std::string("pictures_") + testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(PicturesTest, ShowTheSampleBeforeAndAtTheStrainWithFramesBetween) {
  const OutputFolder output = OutputFolder::open(folder_, "fig03_undrained");
  std::vector<Shot> shots;
  for (const double strain : frame_strains(0.25)) shots.push_back({10.0 * strain, strain, touching_lattice(4, 5)});
  write_frames(output, "curve", shots);
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
  EXPECT_NE(collection.find("timestep=\"2.5\""), std::string::npos) << collection;  // the time of the last shot
}

TEST(FrameStrains, RiseEvenlyFromZero) {
  EXPECT_EQ(frame_strains(0.25), (std::vector{0.0, 0.25 / 5.0, 0.5 / 5.0, 0.75 / 5.0, 1.0 / 5.0, 0.25}));
}

}  // namespace
}  // namespace flowslide
