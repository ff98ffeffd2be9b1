// SPDX-License-Identifier: GPL-2.0-or-later
#include "grains/void_ratio_profile.hpp"

#include <algorithm>
#include <cmath>

#include "grains/measures.hpp"
#include "grains/require.hpp"

namespace flowslide {
namespace {

constexpr std::size_t wall_slices = 2;  ///< see without_wall_layers
constexpr double slice_scatter = 0.27;  ///< see counting_deviation

/// Adds the parts of a sphere to the solid volumes (m^3) of the slices. `centre` is its distance from the lower end of
/// the cell (m).
void cut(std::vector<double>& solid, double thickness, double centre, double radius) {
  const int last = static_cast<int>(solid.size()) - 1;
  const int from = std::max(0, static_cast<int>(std::floor((centre - radius) / thickness)));
  const int to = std::min(last, static_cast<int>(std::floor((centre + radius) / thickness)));
  for (int slice = from; slice <= to; ++slice)
    solid[static_cast<std::size_t>(slice)] +=
        volume_below(radius, (slice + 1) * thickness - centre) - volume_below(radius, slice * thickness - centre);
}

}  // namespace

std::vector<double> void_ratio_profile(const Assembly& assembly, int axis, int slices) {
  require(slices >= 1, "number of slices", slices, ">= 1", "Use one for each mean diameter.");
  const Cell& cell = assembly.cell;
  const double length = cell.lengths()[axis], thickness = length / slices;
  const int images = cell.periodic[axis] ? 1 : 0;
  std::vector<double> solid(static_cast<std::size_t>(slices), 0.0);
  for (std::size_t i = 0; i < assembly.size(); ++i)
    for (int image = -images; image <= images; ++image)
      cut(solid, thickness, assembly.position[i][axis] - cell.lower[axis] + image * length, assembly.radius[i]);
  std::vector<double> void_ratios;
  for (const double volume : solid) {
    require(volume > 0.0, "solid volume of a slice", volume, "> 0 m^3", "Use fewer slices.");
    void_ratios.push_back(cell.volume() / slices / volume - 1.0);
  }
  return void_ratios;
}

int slices_of_a_diameter(const Assembly& assembly, int axis) {
  return std::max(1, static_cast<int>(std::lround(assembly.cell.lengths()[axis] / assembly.mean_diameter())));
}

std::vector<double> without_wall_layers(const std::vector<double>& slices) {
  if (slices.empty()) return {};
  const auto layers = static_cast<std::ptrdiff_t>(std::min<std::size_t>(wall_slices, (slices.size() - 1) / 2));
  return {slices.begin() + layers, slices.end() - layers};
}

double counting_deviation(double cross_section, double mean_diameter) {
  return slice_scatter * mean_diameter / std::sqrt(cross_section);
}

}  // namespace flowslide
