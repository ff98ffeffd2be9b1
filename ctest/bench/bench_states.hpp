// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <string>
#include <vector>

#include "grains/assembly.hpp"

namespace flowslide {

/// A sample to be timed, and how it is sheared meanwhile.
struct BenchState {
  std::string name;
  double shear_rate = 0.0;  ///< 1/s
  Assembly assembly;
};

/// Names of the states: "rest", "shear" (I = 1e-3), "liquefied" and "runout" (4 m/s over h_s = 0.2 m).
std::vector<std::string> bench_state_names();

/// A state of about that many grains, from a sample of the cache, which is prepared if it is not there. More than 20
/// 000 grains are copies, side by side, of a sample of 8800. Every state but the first two is reached by undrained
/// shear.
BenchState bench_state(const std::string& name, int grains);

/// `across` times `along` copies of a cell that is periodic in x and y, side by side, contacts and histories with them.
Assembly tiled(const Assembly& assembly, int across, int along);

}  // namespace flowslide
