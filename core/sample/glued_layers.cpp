// SPDX-License-Identifier: GPL-2.0-or-later
#include "sample/glued_layers.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "sample/failure.hpp"

namespace flowslide {
namespace {

/// Largest gap between a grain of one layer and its plane, as a fraction of the mean diameter.
constexpr double layer_reach = 0.25;
/// Height of each outer share, as a fraction of the height of the cell.
constexpr double outer_share = 0.05;

}  // namespace

void glue_layers(Assembly& assembly, Glue glue) {
  std::size_t count[2] = {0, 0};
  const bool by_gap = glue == Glue::one_layer;
  const double reach = by_gap ? layer_reach * assembly.mean_diameter() : outer_share * assembly.cell.height();
  for (std::size_t i = 0; i < assembly.size(); ++i) {
    const double z = assembly.position[i].z(), inner = by_gap ? assembly.radius[i] : 0.0;
    const bool bottom = z - assembly.cell.lower.z() - inner < reach;
    const bool top = assembly.cell.upper.z() - z - inner < reach;
    if (!bottom && !top) continue;
    if (bottom && top)
      throw NumericalFailure(
          fmt::format("grain {} touches the bottom and the top: the cell is {} m high, too low for "
                      "two glued layers; use more lattice layers",
                      i, assembly.cell.height()));
    assembly.role[i] = bottom ? Role::bottom_layer : Role::top_layer;
    assembly.velocity[i].setZero();
    assembly.spin[i].setZero();
    ++count[top];
  }
  if (count[0] == 0 || count[1] == 0)
    throw NumericalFailure(
        fmt::format("{} grains touch the bottom and {} the top: no layer to glue; the sample is not "
                    "under stress",
                    count[0], count[1]));
  std::erase_if(assembly.contacts, [&](const ContactHistory& contact) {
    return assembly.role[contact.first] != Role::mobile &&
           assembly.role[contact.first] == assembly.role[contact.second];
  });
}

LayerThickness layer_thickness(const Assembly& assembly) {
  LayerThickness thickness;
  for (std::size_t i = 0; i < assembly.size(); ++i) {
    const double z = assembly.position[i].z();
    if (assembly.role[i] == Role::bottom_layer)
      thickness.bottom = std::max(thickness.bottom, z - assembly.cell.lower.z());
    if (assembly.role[i] == Role::top_layer) thickness.top = std::max(thickness.top, assembly.cell.upper.z() - z);
  }
  return thickness;
}

}  // namespace flowslide
