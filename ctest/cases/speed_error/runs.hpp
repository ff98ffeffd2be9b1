// SPDX-License-Identifier: GPL-2.0-or-later
// Replicates made up for tests.
#pragma once
#include "experiment/ensemble.hpp"

namespace flowslide {

/// Replicates of a pulse on 1000 grains with these largest velocities (m/s), each at this cost (s, DEM steps).
inline Ensemble pulses(const std::vector<double>& velocities, double seconds = 1.0, double steps = 1e5) {
  Ensemble all(velocities.size());
  for (std::size_t i = 0; i < velocities.size(); ++i) {
    all[i].provenance.replicate = static_cast<int>(i);
    all[i].metrics = {{"largest_velocity", velocities[i], "m/s", ""}, {"runout", 2.0, "m", ""},
                      {"grains", 1000.0, "1", ""},                    {"steps", steps, "1", ""},
                      {"grain_steps", 1000.0 * steps, "1", ""},       {"processor_seconds", seconds, "s", ""}};
    all[i].metrics[1].value += 0.1 * static_cast<double>(i);  // a spread of its own
  }
  return all;
}

}  // namespace flowslide
