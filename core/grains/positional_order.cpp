// SPDX-License-Identifier: GPL-2.0-or-later
#include "grains/positional_order.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "grains/require.hpp"

namespace flowslide {
namespace {

/// Fraction of the length of the cell that is not affected by layers at its planes.
constexpr double middle_share = 0.6;

/// Order of the grains whose distance from the middle is at most the fraction `reach` of the length.
MiddleOrder order_within(const Assembly& assembly, int axis, int periods, double reach) {
  require(periods >= 1, "number of waves", periods, ">= 1", "Use the number of lattice sites along the axis.");
  const double length = assembly.cell.lengths()[axis], lower = assembly.cell.lower[axis];
  std::complex<double> sum = 0.0;
  MiddleOrder order;
  for (const Vector3& position : assembly.position) {
    const double place = (position[axis] - lower) / length;
    if (std::abs(place - 0.5) > reach) continue;
    const double phase = 2.0 * std::numbers::pi * periods * place;
    sum += std::complex<double>(std::cos(phase), std::sin(phase));
    ++order.grains;
  }
  if (order.grains > 0) order.value = std::abs(sum) / static_cast<double>(order.grains);
  return order;
}

}  // namespace

double positional_order(const Assembly& assembly, int axis, int periods) {
  require(assembly.size() > 0, "number of grains", 0, ">= 1", "The assembly holds no grain.");
  constexpr double everywhere = 1e9;
  return order_within(assembly, axis, periods, everywhere).value;
}

MiddleOrder middle_order(const Assembly& assembly, int axis, int periods) {
  const int waves = std::max(1, static_cast<int>(std::lround(middle_share * periods)));
  return order_within(assembly, axis, periods, 0.5 * waves / periods);
}

double order_of_random_positions(std::size_t grains, double deviations) {
  constexpr double pi = std::numbers::pi;
  const double mean = std::sqrt(0.25 * pi), deviation = std::sqrt(1.0 - 0.25 * pi);
  return (mean + deviations * deviation) / std::sqrt(static_cast<double>(grains));
}

}  // namespace flowslide
