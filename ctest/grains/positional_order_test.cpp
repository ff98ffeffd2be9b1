// SPDX-License-Identifier: GPL-2.0-or-later
#include "grains/positional_order.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "cubic_lattice.hpp"
#include "grains/packing.hpp"
#include "random_assembly.hpp"

namespace flowslide {
namespace {

TEST(PositionalOrder, OfAPerfectLatticeIsOneAtItsWaveNumberAndNoneBeside) {
  Assembly lattice = testing::cubic_lattice(10, 1.1, false);
  lattice.cell.lower.x() -= 3.0;  // wherever the cell begins
  lattice.cell.upper.x() -= 3.0;
  for (Vector3& position : lattice.position) position.x() -= 3.0;
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(positional_order(lattice, axis, 10), 1.0, 1e-13);
    EXPECT_NEAR(positional_order(lattice, axis, 20), 1.0, 1e-13);
    EXPECT_NEAR(positional_order(lattice, axis, 9), 0.0, 1e-13);
    EXPECT_NEAR(middle_order(lattice, axis, 10).value, 1.0, 1e-13);
    EXPECT_EQ(middle_order(lattice, axis, 10).grains, 6u * 10u * 10u);  // of ten layers
  }
}

TEST(PositionalOrder, OfAUniformSpreadIsThatOfItsFactor) {
  // N evenly spaced positions over a share s of a wave: |sum| = |sin(pi s)/(N sin(pi s/N))|.
  Assembly row;
  row.resize(50);
  row.cell.upper = Vector3(1.0, 1.0, 1.0);
  for (std::size_t i = 0; i < 50; ++i) row.position[i].z() = 0.7 * static_cast<double>(i) / 50.0;
  const double pi = std::numbers::pi;
  EXPECT_NEAR(positional_order(row, 2, 1), std::sin(0.7 * pi) / (50.0 * std::sin(0.7 * pi / 50.0)), 1e-13);
}

TEST(PositionalOrder, OfIndependentPositionsIsRayleighsLaw) {
  constexpr std::size_t grains = 400;
  constexpr int clouds = 500;
  double sum = 0.0, squares = 0.0, above = 0.0;
  for (std::uint64_t seed = 1; seed <= clouds; ++seed) {
    const double order =
        positional_order(testing::random_cloud(seed, grains, {0.1, 0.1, 0.1}, {false, false, false}), 2, 11);
    sum += order;
    squares += order * order;
    above += order > order_of_random_positions(grains, 2.0);
  }
  const double pi = std::numbers::pi;
  // The mean of 500 scatters by 0.463/sqrt(400 * 500); that of the squares, exponential, by 1/(400 sqrt(500)).
  EXPECT_NEAR(sum / clouds, std::sqrt(0.25 * pi / grains), 4 * 0.463 / std::sqrt(1.0 * grains * clouds));
  EXPECT_NEAR(squares / clouds, 1.0 / grains, 4.0 / (grains * std::sqrt(1.0 * clouds)));
  EXPECT_NEAR(above / clouds, std::exp(-std::pow(std::sqrt(0.25 * pi) + 2 * std::sqrt(1 - 0.25 * pi), 2)),
              4 * std::sqrt(0.037 / clouds));
}

TEST(PositionalOrder, AUniformMiddleHasNone) {
  // Whole waves: an even row of positions, which has order over the whole of a cell that it does not fill, has none.
  Assembly row;
  row.resize(10'000);
  row.cell.upper = Vector3(1.0, 1.0, 1.0);
  for (std::size_t i = 0; i < 10'000; ++i) row.position[i].y() = 0.1 + 0.8 * (static_cast<double>(i) + 0.5) / 10'000;
  for (const int periods : {10, 11, 20, 22}) EXPECT_LT(middle_order(row, 1, periods).value, 5e-4) << periods;
  EXPECT_GT(positional_order(row, 1, 11), 0.01);
}

TEST(PositionalOrder, ShowsTheLatticeThatPreparationsBeginWith) {
  const Assembly packing = lattice_packing({.counts = {10, 10, 11}});
  // Shifts of up to s = 0.04/1.1 of a spacing leave sin(2 pi s)/(2 pi s) of it: 0.991.
  EXPECT_NEAR(positional_order(packing, 2, 11), 0.991, 0.002);
  EXPECT_GT(middle_order(packing, 0, 10).value, order_of_random_positions(middle_order(packing, 0, 10).grains, 2.0));
}

TEST(PositionalOrder, RefusesNoGrainsAndNoWave) {
  EXPECT_THROW(positional_order({}, 0, 8), std::invalid_argument);
  EXPECT_THROW(positional_order(testing::cubic_lattice(3, 1.0, true), 0, 0), std::invalid_argument);
}

}  // namespace
}  // namespace flowslide
