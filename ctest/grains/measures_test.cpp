// SPDX-License-Identifier: GPL-2.0-or-later
#include "grains/measures.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "cubic_lattice.hpp"
#include "hertz_contact_time.hpp"

namespace flowslide::measures_test {
namespace {

constexpr double pi = std::numbers::pi;

using testing::cubic_lattice;
using testing::hertz_contact_time;

TEST(VoidRatio, OfACubicLattice) {
  // A sphere of volume pi/6 in each unit cube. Tolerance: rounding.
  EXPECT_NEAR(void_ratio(cubic_lattice(4, 1.0, false)), 6.0 / pi - 1.0, 1e-13);
  EXPECT_NEAR(void_ratio(cubic_lattice(4, 2.0, true)), 48.0 / pi - 1.0, 1e-12);
  EXPECT_THROW(void_ratio(Assembly{}), std::invalid_argument);
}

TEST(VoidRatioOfBulk, WithoutMarginIsThatOfTheCell) {
  const Assembly assembly = cubic_lattice(3, 1.25, false);
  EXPECT_NEAR(void_ratio_of_bulk(assembly, 0.0), void_ratio(assembly), 1e-13);
}

TEST(VoidRatioOfBulk, CountsTheHalvesOfSpheresCutThroughTheirCentres) {
  // From the centres of the lowest layer to those of the highest: as dense as the lattice.
  EXPECT_NEAR(void_ratio_of_bulk(cubic_lattice(4, 1.0, false), 0.5), 6.0 / pi - 1.0, 1e-13);
}

TEST(VoidRatioOfBulk, CountsCaps) {
  // One sphere of radius 1 in the middle of a 2 x 2 x 4 cell, cut 0.5 above and below its centre: what remains is the
  // sphere less two caps of depth 1/2, 4/3 pi - 2 * pi/4 * (3 - 1/2)/3 = 11/12 pi, in 4 m^3.
  Assembly assembly;
  assembly.resize(1);
  assembly.radius[0] = 1.0;
  assembly.position[0] = Vector3(1.0, 1.0, 2.0);
  assembly.cell.upper = Vector3(2.0, 2.0, 4.0);
  EXPECT_NEAR(void_ratio_of_bulk(assembly, 1.5), (4.0 - 11.0 / 12.0 * pi) / (11.0 / 12.0 * pi), 1e-13);
}

TEST(VoidRatioOfBulk, RefusesImpossibleMargins) {
  const Assembly assembly = cubic_lattice(3, 2.0, false);
  EXPECT_THROW(void_ratio_of_bulk(assembly, -0.1), std::invalid_argument);
  EXPECT_THROW(void_ratio_of_bulk(assembly, 3.0), std::invalid_argument);
  EXPECT_THROW(void_ratio_of_bulk(cubic_lattice(4, 2.0, false), 3.6), std::invalid_argument);  // between two layers
}

TEST(ProbeVoidRatio, LeavesOutTheOuterShareAtEachEnd) {
  const Assembly assembly = cubic_lattice(4, 1.25, false);
  EXPECT_EQ(probe_void_ratio(assembly), void_ratio_of_bulk(assembly, 0.075 * assembly.cell.height()));
  EXPECT_LT(probe_void_ratio(assembly), void_ratio(assembly));
}

TEST(VolumeBelow, OfASphere) {
  EXPECT_EQ(volume_below(2.0, -2.0), 0.0);
  EXPECT_EQ(volume_below(2.0, -5.0), 0.0);
  EXPECT_DOUBLE_EQ(volume_below(2.0, 0.0), 16.0 / 3.0 * pi);
  EXPECT_DOUBLE_EQ(volume_below(2.0, 3.0), 32.0 / 3.0 * pi);
  EXPECT_DOUBLE_EQ(volume_below(2.0, -1.0), 5.0 / 3.0 * pi);  // cap of depth 1: pi (6 - 1) / 3
}

TEST(InertialNumber, OfThePaper) {
  // 0.06 /s, 6 mm, 28.34 kPa: 1.1e-4 as printed; tolerance: half a unit of the last digit.
  EXPECT_NEAR(inertial_number(0.06, 6e-3, 2650.0, 28340.0), 1.1e-4, 0.05e-4);
  EXPECT_DOUBLE_EQ(inertial_number(2.0, 3.0, 4.0, 16.0), 3.0);
  EXPECT_DOUBLE_EQ(inertial_number(-2.0, 3.0, 4.0, 16.0), -3.0);
  EXPECT_DOUBLE_EQ(shear_rate_for(3.0, 3.0, 4.0, 16.0), 2.0);
}

TEST(InertialNumber, RefusesVanishingPressure) {
  EXPECT_THROW(inertial_number(1.0, 1.0, 1.0, 0.0), std::invalid_argument);
  EXPECT_THROW(shear_rate_for(1.0, 1.0, 1.0, -1.0), std::invalid_argument);
  EXPECT_THROW(inertial_number(1.0, 0.0, 1.0, 1.0), std::invalid_argument);
  EXPECT_THROW(inertial_number(1.0, 1.0, std::nan(""), 1.0), std::invalid_argument);
}

TEST(RayleighTime, OfTheSmallestSphereOfThePaper) {
  // pi * 2.5e-3 * sqrt(2650 / 0.8e9) / 0.917375 = 1.5582e-5 s; tolerance: the digits written.
  EXPECT_NEAR(rayleigh_time(2.5e-3, Material{}), 1.5582e-5, 0.5e-9);
  EXPECT_NEAR(5e-7 / rayleigh_time(2.5e-3, Material{}), 0.032, 0.0005);
}

/// 2 * integral of dx / sqrt(1 - x^(5/2)) over [0, 1], with x = 1 - s^2 and the midpoint rule.
double hertz_factor() {
  const int intervals = 100000;
  double sum = 0.0;
  for (int k = 0; k < intervals; ++k) {
    const double s = (k + 0.5) / intervals;
    sum += 2.0 * s / std::sqrt(1.0 - std::pow(1.0 - s * s, 2.5));
  }
  return 2.0 * sum / intervals;
}

TEST(HertzImpact, OfTwoEqualSpheres) {
  // R = 2, nu = 0, E = 2: R* = 1, Y* = 1. With m* = 16/15, so m = 32/15, and unit speed the overlap is 1.
  Material material;
  material.youngs_modulus = 2.0;
  material.poisson_ratio = 0.0;
  material.density = 32.0 / 15.0 / (4.0 / 3.0 * pi * 8.0);
  EXPECT_NEAR(hertz_impact_overlap(2.0, material, 1.0), 1.0, 1e-14);
  // The midpoint rule with 1e5 intervals is exact to some 1e-9 (second order, smooth integrand).
  EXPECT_NEAR(hertz_contact_time(2.0, material, 1.0), hertz_factor(), 1e-8);
  // Overlap ~ v^(4/5), time ~ v^(-1/5).
  EXPECT_NEAR(hertz_impact_overlap(2.0, material, 32.0), 16.0, 1e-12);
  EXPECT_NEAR(hertz_contact_time(2.0, material, 32.0), hertz_factor() / 2.0, 1e-8);
  EXPECT_THROW(hertz_impact_overlap(2.0, material, 0.0), std::invalid_argument);
}

}  // namespace
}  // namespace flowslide::measures_test
