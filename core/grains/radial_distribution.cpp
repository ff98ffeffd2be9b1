// SPDX-License-Identifier: GPL-2.0-or-later
#include "grains/radial_distribution.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "grains/require.hpp"

namespace flowslide {
namespace {

/// Fraction of the surface of a sphere of `radius` (m), with its centre at `height` (m), that is inside the cell.
double share_inside(const Cell& cell, double height, double radius) {
  if (cell.periodic[2]) return 1.0;
  const auto to = [&](double distance) { return 0.5 * std::min(1.0, distance / radius); };
  return to(height - cell.lower.z()) + to(cell.upper.z() - height);
}

/// Number of ordered pairs per bin, shape (bins); bins are `width` (m) wide.
std::vector<double> count_pairs(const Assembly& assembly, double width, int bins) {
  std::vector<double> pairs(static_cast<std::size_t>(bins), 0.0);
  for (std::size_t i = 0; i < assembly.size(); ++i)
    for (std::size_t j = i + 1; j < assembly.size(); ++j) {
      const Vector3 apart = assembly.cell.nearest_image(assembly.position[i] - assembly.position[j]);
      const double bin = apart.norm() / width;
      if (bin < bins) pairs[static_cast<std::size_t>(bin)] += 2.0;
    }
  return pairs;
}

}  // namespace

RadialDistribution radial_distribution(const Assembly& assembly, double reach, int bins) {
  require(bins >= 1, "number of bins", bins, ">= 1", "Use more bins.");
  require(reach > 0.0, "reach", reach, "> 0 mean diameters", "Use 3.");
  require(assembly.size() > 1, "number of grains", static_cast<double>(assembly.size()), ">= 2", "Use more grains.");
  const Cell& cell = assembly.cell;
  const double diameter = assembly.mean_diameter(), width = reach * diameter / bins;
  for (int axis = 0; axis < 3; ++axis) {
    if (axis == 2 && !cell.periodic[2]) continue;
    require(cell.periodic[axis] && cell.lengths()[axis] >= 2.0 * reach * diameter, "reach", reach,
            "at most half of each periodic length, and x and y must be periodic", "Use a smaller reach.");
  }
  const std::vector<double> pairs = count_pairs(assembly, width, bins);
  const double per_volume = static_cast<double>(assembly.size() - 1) / cell.volume();
  RadialDistribution found;
  for (int bin = 0; bin < bins; ++bin) {
    const double inner = bin * width, outer = inner + width, middle = inner + 0.5 * width;
    const double shell = 4.0 / 3.0 * std::numbers::pi * (outer * outer * outer - inner * inner * inner);
    double expected = 0.0;
    for (const Vector3& position : assembly.position)
      expected += per_volume * shell * share_inside(cell, position.z(), middle);
    found.distance.push_back(middle / diameter);
    found.density.push_back(pairs[static_cast<std::size_t>(bin)] / expected);
  }
  return found;
}

}  // namespace flowslide
