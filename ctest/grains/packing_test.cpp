// SPDX-License-Identifier: GPL-2.0-or-later
#include "grains/packing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <stdexcept>
#include <string>

namespace flowslide {
namespace {

constexpr std::int64_t count = 8800;

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// In the order of the grains, m.
std::vector<double> diameters_of(LatticePacking options = {}) {
  std::vector<double> diameters;
  for (const double radius : lattice_packing(options).radius) diameters.push_back(2.0 * radius);
  return diameters;
}

TEST(Diameters, NumberMeanIsThatOfThePaper) {
  const auto diameters = diameters_of();
  ASSERT_EQ(diameters.size(), 8800u);
  // 2 D_min D_max / (D_min + D_max) = 2 * 5 * 7.5 / 12.5 mm. Of a monotone function, one sample in each of n equal
  // intervals of u has a mean within (largest - smallest) / n of the integral.
  EXPECT_NEAR(mean(diameters), 6.0e-3, 2.5e-3 / count);
}

TEST(Diameters, EqualIntervalsOfDiameterHoldEqualSolidVolume) {
  const auto diameters = diameters_of();
  std::vector<double> volume(5, 0.0);
  for (const double d : diameters) {
    const double interval = std::floor((d - 5.0e-3) / 0.5e-3);
    ASSERT_GE(interval, 0.0);
    ASSERT_LT(interval, 5.0);
    volume[static_cast<std::size_t>(interval)] += d * d * d;
  }
  const double total = std::accumulate(volume.begin(), volume.end(), 0.0);
  // d^3 within an interval and 0 outside has a total variation of at most 2 D_max^3: the sum is off by at most that.
  for (const double part : volume) EXPECT_NEAR(part, total / 5.0, 2.0 * std::pow(7.5e-3, 3) * 1.2);
}

TEST(Diameters, OrderIsShuffled) {
  const auto diameters = diameters_of();
  const std::vector<double> half(diameters.begin(), diameters.begin() + count / 2);
  // The standard deviation of D is 0.70 mm; the mean of half of the grains scatters by 0.70 / sqrt(8800) = 0.0075 mm.
  EXPECT_NEAR(mean(half), 6.0e-3, 5 * 0.0075e-3);
  EXPECT_FALSE(std::is_sorted(diameters.begin(), diameters.end()));
}

TEST(Diameters, SameSeedSameDrawOtherSeedOtherDraw) {
  LatticePacking options;
  options.counts = {4, 5, 5};
  const auto first = diameters_of(options);
  EXPECT_EQ(diameters_of(options), first);
  options.seed = 2;
  EXPECT_NE(diameters_of(options), first);
}

TEST(Diameters, OneSize) {
  LatticePacking options;
  options.smallest_diameter = options.largest_diameter = 6e-3;
  options.counts = {3, 3, 3};
  for (const double d : diameters_of(options)) EXPECT_DOUBLE_EQ(d, 6e-3);
}

TEST(LatticePacking, DefaultIsThatOfThePaper) {
  const Assembly assembly = lattice_packing();
  EXPECT_EQ(assembly.size(), 8800u);
  EXPECT_TRUE(assembly.contacts.empty());
  EXPECT_EQ(assembly.cell.periodic, (std::array<bool, 3>{false, false, false}));
  // 20, 20, 22 sites of 1.1 * 7.5 mm; tolerance: rounding.
  EXPECT_TRUE(assembly.cell.lengths().isApprox(Vector3(0.165, 0.165, 0.1815), 1e-14));
  EXPECT_TRUE(std::all_of(assembly.role.begin(), assembly.role.end(), [](Role r) { return r == Role::mobile; }));
  for (const auto* array : {&assembly.velocity, &assembly.spin, &assembly.force, &assembly.torque})
    for (const Vector3& value : *array) EXPECT_EQ(value, Vector3::Zero());
}

TEST(LatticePacking, NothingTouches) {
  LatticePacking options;
  options.counts = {6, 5, 7};
  options.smallest_diameter = options.largest_diameter;  // the worst case: all of the largest size
  options.jitter = 0.2;
  options.spacing = 1.4 + 1e-9;
  for (options.seed = 1; options.seed <= 5; ++options.seed) {
    const Assembly a = lattice_packing(options);
    for (std::size_t i = 0; i < a.size(); ++i) {
      EXPECT_GT((a.position[i] - a.cell.lower).minCoeff(), a.radius[i]);
      EXPECT_GT((a.cell.upper - a.position[i]).minCoeff(), a.radius[i]);
      for (std::size_t j = i + 1; j < a.size(); ++j)
        EXPECT_GT((a.position[i] - a.position[j]).norm(), a.radius[i] + a.radius[j]);
    }
  }
}

TEST(LatticePacking, JitterMovesEveryCentreWithinItsBound) {
  LatticePacking options;
  options.counts = {4, 3, 5};
  options.jitter = 0.0;
  const Assembly lattice = lattice_packing(options);
  // Second site along x, third along y, first along z: index 1 + 4 * 2.
  EXPECT_TRUE(lattice.position[9].isApprox(8.25e-3 * Vector3(1.5, 2.5, 0.5), 1e-14));
  options.jitter = 0.04;
  const Assembly jittered = lattice_packing(options);
  double largest = 0.0;
  for (std::size_t i = 0; i < lattice.size(); ++i) {
    const double shift = (jittered.position[i] - lattice.position[i]).cwiseAbs().maxCoeff();
    EXPECT_GT(shift, 0.0);
    largest = std::max(largest, shift);
  }
  EXPECT_LE(largest, 0.04 * 7.5e-3 * (1 + 1e-12));  // rounding
  EXPECT_GT(largest, 0.9 * 0.04 * 7.5e-3);          // 180 draws miss the outer tenth with a chance of 0.9^180 = 6e-9
}

TEST(LatticePacking, RefusesOptionsOutOfRange) {
  const auto refused = [](const std::function<void(LatticePacking&)>& change, const std::string& name) {
    LatticePacking options;
    change(options);
    try {
      lattice_packing(options);
      ADD_FAILURE() << name << " accepted";
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
    }
  };
  refused([](LatticePacking& o) { o.counts[0] = 2; }, "lattice = 2");
  refused([](LatticePacking& o) { o.counts[2] = -5; }, "lattice = -5");
  refused([](LatticePacking& o) { o.smallest_diameter = 0.0; }, "smallest_diameter");
  refused([](LatticePacking& o) { o.smallest_diameter = std::nan(""); }, "smallest_diameter");
  refused([](LatticePacking& o) { o.largest_diameter = 4e-3; }, "largest_diameter");
  refused([](LatticePacking& o) { o.jitter = -0.01; }, "jitter");
  refused([](LatticePacking& o) { o.spacing = 1.08; }, "spacing");
}

}  // namespace
}  // namespace flowslide
