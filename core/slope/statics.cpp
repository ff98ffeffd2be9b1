// SPDX-License-Identifier: GPL-2.0-or-later
#include "slope/statics.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include "slope/require.hpp"

namespace flowslide {
namespace {

double buoyant_mass_per_area(const SlopeProperties& slope) {
  return (slope.saturated_density - slope.water_density) * slope.water_table +
         slope.dry_density * (slope.thickness - slope.water_table);
}

}  // namespace

void validate(const SlopeProperties& slope) {
  const std::string density_remedy = "Give the density in kg/m^3, such as 1500.";
  require_positive("saturated density", slope.saturated_density, "kg/m^3", density_remedy);
  require_positive("dry density", slope.dry_density, "kg/m^3", density_remedy);
  require_positive("water density", slope.water_density, "kg/m^3", density_remedy);
  require_of_slope(slope.saturated_density > slope.water_density, "saturated density", slope.saturated_density,
                   fmt::format("more than the water density {} kg/m^3", slope.water_density),
                   "Give the density of soil and pore water together.");
  require_of_slope(slope.dry_density <= slope.saturated_density, "dry density", slope.dry_density,
                   fmt::format("at most the saturated density {} kg/m^3", slope.saturated_density),
                   "Make it smaller, or the saturated density larger: saturated soil weighs more by its pore water.");
  require_positive("gravity", slope.gravity, "m/s^2", "Give its magnitude, such as 9.81.");
  require_positive("thickness", slope.thickness, "m", "Give the thickness of the whole sliding mass.");
  require_positive("liquefiable thickness", slope.liquefiable_thickness, "m", "Give the layer at the base.");
  const std::string thickness = fmt::format("{} m (the thickness)", slope.thickness);
  require_of_slope(slope.liquefiable_thickness <= slope.thickness, "liquefiable thickness",
                   slope.liquefiable_thickness, "at most " + thickness,
                   "Make the layer thinner or the slope thicker.");
  require_of_slope(slope.water_table >= 0.0 && slope.water_table <= slope.thickness, "water table", slope.water_table,
                   "0 to " + thickness, "Measure it from the base of the slide.");
  require_of_slope(slope.angle >= 0.0 && slope.angle < std::numbers::pi / 2.0, "angle", slope.angle,
                   "[0, pi/2) rad", "Give the angle in radians; 5 degrees is 0.0873 rad.");
  require_of_slope(std::isfinite(slope.hydraulic_conductivity) && slope.hydraulic_conductivity >= 0.0,
                   "hydraulic conductivity", slope.hydraulic_conductivity, "finite and >= 0 m/s",
                   "Use 0 for undrained.");
}

double mass_per_area(const SlopeProperties& slope) {
  validate(slope);
  return slope.saturated_density * slope.water_table + slope.dry_density * (slope.thickness - slope.water_table);
}

double initial_shear_stress(const SlopeProperties& slope) {
  return mass_per_area(slope) * slope.gravity * std::sin(slope.angle);
}

double initial_normal_stress(const SlopeProperties& slope) {
  validate(slope);
  return buoyant_mass_per_area(slope) * slope.gravity * std::cos(slope.angle);
}

}  // namespace flowslide
