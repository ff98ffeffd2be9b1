// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <string>

namespace flowslide {

/// A configuration of two slides on 150 grains, or on a closed-form sample.
inline std::string slide_case_text() {
  return R"(engine = "elastic"
seed = 1
replicates = 3
[slope]
saturated_density = "2000 kg/m^3"
dry_density = "1500 kg/m^3"
thickness = "2 m"
liquefiable_thickness = "0.2 m"
water_table = "0.2 m"
angle = "5 deg"
hydraulic_conductivity = 0
[material]
density = "2650 kg/m^3"
youngs_modulus = "2 GPa"
poisson_ratio = 0.25
restitution = 0.8
sliding_friction = 0.5
rolling_friction = 0.1
rolling_stiffness = 2.25
rolling_viscous_damping = 0.13
[packing]
lattice = [5, 5, 6]
smallest_diameter = "5 mm"
largest_diameter = "7.5 mm"
[preparation]
engine = "native"
time_step = "1e-5 s"
loose_void_ratio = 1.2
compaction_rate = "2 1/s"
servo_rates = ["0.2 1/s", "0.1 1/s", "0.05 1/s"]
servo_interval = 30
stress_tolerance = 5e-3
kinetic_tolerance = 1e-8
mixing = "0 m/s"
drag_reference = "rest"
drag_stages = [1, 2, 3, 4]
restitution = 0.8
allow_uneven = true
[sample.loose]
void_ratio = 0.79
tolerance = 0.2
most_trials = 1
preparation_friction = 0.5
drag = "0.06 kg/s"
isotropic = false
[coupling]
time_step = "1e-4 s"
n_accum = 10
local_time_step = "1e-5 s"
most_steps = 100000
consolidation = "exponential"
residual = "fades"
shear_modulus = "40 MPa"
oedometric_modulus = "100 MPa"
allow_unstable = false
[scheme.RD]
passing = "carry_remainder"
rate = "global"
[scheme.RI]
passing = "whole_increment"
rate = "constant_inertial_number"
inertial_number = 1e-4
smallest_rate = "2 1/s"
[profiles]
sublayers = 4
snapshots = 2
window = 0.5
[loading]
history = "pulse"
amplitude = "3 kPa"
duration = "2 s"
[stop]
end_time = "4 s"
[rows]
most_rows = 100
row_interval = "0.1 s"
[elastic]
shear_modulus = "15 MPa"
oedometric_modulus = "40 MPa"
viscosity = 0
void_ratio = 0.79
[point.RD]
figures = ["11", "12"]
sample = "loose"
scheme = "RD"
[point.RI]
figures = "12"
sample = "loose"
scheme = "RI"
)";
}

}  // namespace flowslide
