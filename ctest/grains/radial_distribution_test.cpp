// SPDX-License-Identifier: GPL-2.0-or-later
#include "grains/radial_distribution.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "cubic_lattice.hpp"
#include "random_assembly.hpp"

namespace flowslide {
namespace {

TEST(RadialDistribution, OfIndependentPositionsIsOneWithAndWithoutPlanes) {
  for (const bool periodic : {true, false}) {
    const Assembly cloud = testing::random_cloud(5, 3000, {0.06, 0.06, 0.05}, {true, true, periodic});
    const RadialDistribution found = radial_distribution(cloud, 3.0, 6);
    double per_bin = 0.0;
    for (std::size_t bin = 0; bin < 6; ++bin) {
      // Pairs in a bin, one way: their number scatters by its root.
      const double inner = 0.5 * static_cast<double>(bin), outer = inner + 0.5, d = cloud.mean_diameter();
      const double shell = 4.0 / 3.0 * std::numbers::pi * (std::pow(outer * d, 3) - std::pow(inner * d, 3));
      per_bin = 0.5 * 3000.0 * 3000.0 * shell / cloud.cell.volume();
      EXPECT_NEAR(found.density[bin], 1.0, 4.0 / std::sqrt(per_bin)) << periodic << bin;
      EXPECT_NEAR(found.distance[bin], inner + 0.25, 1e-12);
    }
  }
}

TEST(RadialDistribution, OfALatticeShowsItsNeighbours) {
  const Assembly lattice = testing::cubic_lattice(8, 1.0, true);
  const RadialDistribution found = radial_distribution(lattice, 2.0, 20);
  // Six at a distance of 1, in a shell from 1 to 1.1 that would hold 4/3 pi 0.331 of them (each sees 511 of 512).
  EXPECT_NEAR(found.density[10], 6.0 / (4.0 / 3.0 * std::numbers::pi * 0.331) * 512.0 / 511.0, 1e-9);
  EXPECT_EQ(found.density[9], 0.0);
  EXPECT_EQ(found.density[12], 0.0);
}

TEST(RadialDistribution, RefusesWhatItCannotTell) {
  const Assembly lattice = testing::cubic_lattice(6, 1.0, true);
  EXPECT_THROW(radial_distribution(lattice, 3.1, 10), std::invalid_argument);
  EXPECT_THROW(radial_distribution(lattice, 2.0, 0), std::invalid_argument);
  EXPECT_THROW(radial_distribution(testing::cubic_lattice(6, 1.0, false), 1.0, 10), std::invalid_argument);
  EXPECT_THROW(radial_distribution({}, 1.0, 10), std::invalid_argument);
}

}  // namespace
}  // namespace flowslide
