// SPDX-License-Identifier: GPL-2.0-or-later
#include "input/vocabulary.hpp"

namespace flowslide {
namespace {

constexpr const char* slides = "slides, which are runs with a scheme";
constexpr const char* shear_tests = "element tests, which are runs with final_strain";

}  // namespace

const std::vector<KeysOfRuns>& vocabulary() {
  static const std::vector<KeysOfRuns> all{
      {{"coupling", "scheme.*", "point.*.coupling"},
       {"time_step", "rate", "inertial_number", "smallest_rate", "smallest_rate_from", "passing", "n_accum",
        "most_steps", "consolidation", "residual", "initial_velocity", "stress_interval", "rest_stress",
        "probed_strain", "rested_strain", "shear_modulus", "oedometric_modulus", "allow_unstable",
        "linear_start"},
       slides},
      {{"loading", "point.*.loading"},
       {"history", "change", "rate", "duration", "final_change", "amplitude", "file"},
       slides},
      {{"stop", "point.*.stop"}, {"end_time", "end_shear_strain", "end_velocity", "sliding_velocity"}, slides},
      {{"rows", "point.*.rows"}, {"most_rows", "row_interval", "row_strain"}, slides},
      {{"point.*"}, {"scheme", "hydraulic_conductivity", "profile_strains"}, slides},
      {{"profiles"}, {"sublayers", "snapshots", "window", "read"}, "slides with profile_strains"},
      {{"shear_test", "point.*"}, {"shear_rate", "inertial_number"}, shear_tests},
      {{"shear_test"}, {"rows", "end_normal_stress"}, shear_tests},
      {{"elastic"}, {"shear_modulus", "oedometric_modulus", "viscosity", "void_ratio"}, "slides with --engine elastic"},
      {{"critical_state"},
       {"critical_friction", "critical_void_ratio", "critical_slope", "reference_stress", "shear_stiffness",
        "oedometric_stiffness", "hardening", "peak_exponent", "dilatancy", "dilatancy_exponent", "void_ratio"},
       "slides with --engine critical_state"}};
  return all;
}

void describe_vocabulary(const Configuration& configuration) {
  for (const KeysOfRuns& keys : vocabulary())
    for (const std::string& table : keys.tables)
      for (const std::string& name : keys.names) configuration.describe_users(table + "." + name, keys.users);
}

}  // namespace flowslide
