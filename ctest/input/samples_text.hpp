// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <string>
#include <vector>

#include "configuration/error.hpp"
#include "input/read_samples.hpp"
#include "support/messages.hpp"

namespace flowslide {

/// A configuration with two samples.
inline constexpr const char* samples_text = R"(seed = 7
[slope]
saturated_density = "2000 kg/m^3"
dry_density = "1500 kg/m^3"
thickness = "2 m"
liquefiable_thickness = "0.2 m"
water_table = "0.2 m"
angle = "5 deg"
hydraulic_conductivity = "1 mm/s"
[material]
density = "2650 kg/m^3"
youngs_modulus = "2 GPa"
poisson_ratio = 0.25
restitution = 0.8
contact_law = "hertz"
sliding_friction = 0.5
rolling_friction = 0.1
rolling_stiffness = 2.25
rolling_viscous_damping = 0.13
torsion_resistance = false
normal_force_limited = false
[packing]
lattice = [4, 5, 6]
smallest_diameter = "5 mm"
largest_diameter = "7.5 mm"
[preparation]
time_step = "1e-5 s"
loose_void_ratio = 1.2
compaction_rate = "1 1/s"
servo_rates = ["0.2 1/s", "0.1 1/s", "0.05 1/s"]
servo_interval = 30
stress_tolerance = 1e-3
kinetic_tolerance = 1e-8
mixing = "0 m/s"
drag_reference = "rest"
drag_stages = [1, 2, 3, 4]
restitution = 0.7
allow_uneven = true
[sample.loose]
void_ratio = 0.79
tolerance = 0.002
most_trials = 8
preparation_friction = 0.4
drag = "0.06 kg/s"
isotropic = false
[sample.isotropic]
void_ratio = 0.77
tolerance = 0.004
most_trials = 3
preparation_friction = 0.3
drag = "0.03 kg/s"
isotropic = true
)";

/// The configuration in which `to` replaces `from`.
inline Configuration with(const std::string& from = "", const std::string& to = "") {
  std::string changed = samples_text;
  changed.replace(changed.find(from), from.size(), to);
  return Configuration::from_text(changed, "case.toml");
}

inline std::vector<SampleSpecification> samples_of(const Configuration& configuration, int replicate = 0) {
  return read_samples(configuration, read_slope(configuration), replicate);
}

/// The message about a configuration in which `to` replaces `from`.
inline std::string complaint(const std::string& from, const std::string& to) {
  return message_of<ConfigurationError>([&] { samples_of(with(from, to)); });
}

}  // namespace flowslide
