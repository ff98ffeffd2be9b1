// SPDX-License-Identifier: GPL-2.0-or-later
#include "sample/glued_layers.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "sample/failure.hpp"

namespace flowslide {

void glue_layers(Assembly& assembly, double reach) {
  std::size_t count[2] = {0, 0};
  for (std::size_t i = 0; i < assembly.size(); ++i) {
    const double z = assembly.position[i].z(), radius = assembly.radius[i];
    const bool bottom = z - assembly.cell.lower.z() - radius < reach;
    const bool top = assembly.cell.upper.z() - z - radius < reach;
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

}  // namespace flowslide
