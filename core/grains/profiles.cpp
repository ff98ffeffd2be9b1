// SPDX-License-Identifier: GPL-2.0-or-later
#include "grains/profiles.hpp"

#include "grains/measures.hpp"
#include "grains/require.hpp"
#include "grains/slab_stress.hpp"
#include "grains/stress.hpp"

namespace flowslide {
namespace {

/// Mean v_x of the solid between two heights (m), relative to the bottom, m/s.
double mean_velocity(const Assembly& assembly, double lower, double upper) {
  const Cell& cell = assembly.cell;
  const int images = cell.periodic[2] ? 1 : 0;
  double flux = 0.0, solid = 0.0;
  for (std::size_t i = 0; i < assembly.size(); ++i)
    for (int image = -images; image <= images; ++image) {
      const double z = assembly.position[i].z() + image * cell.height(), radius = assembly.radius[i];
      const double volume = volume_below(radius, upper - z) - volume_below(radius, lower - z);
      flux += volume * (assembly.velocity[i].x() + (image + 0.5) * cell.shear_velocity);
      solid += volume;
    }
  require(solid > 0.0, "solid volume of a sublayer", solid, "> 0 m^3", "Use fewer sublayers.");
  return flux / solid;
}

}  // namespace

Profiles profiles(const Assembly& assembly, const ContactForces& forces, int sublayers) {
  require(sublayers > 0, "number of sublayers", sublayers, "1 or more", "The paper has 10.");
  Profiles result;
  const double thickness = assembly.cell.height() / sublayers;
  for (int layer = 0; layer < sublayers; ++layer) {
    const double lower = assembly.cell.lower.z() + layer * thickness;
    const SlopeStress stress = slope_stress(slab_stress(assembly, forces, lower, lower + thickness));
    result.height.push_back((layer + 0.5) * thickness);
    result.velocity.push_back(mean_velocity(assembly, lower, lower + thickness));
    result.shear_stress.push_back(stress.shear);
    result.normal_stress.push_back(stress.normal);
  }
  return result;
}

}  // namespace flowslide
