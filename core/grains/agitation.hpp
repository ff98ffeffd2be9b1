// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <cstdint>

#include "grains/assembly.hpp"

namespace flowslide {

/// Gives the mobile grains random velocities: normal (see random.hpp) with the standard deviation `speed` (m/s) along
/// each axis, less their mean weighted by volume, so that the grains have no momentum. `seed`: any value; equal seeds
/// give equal velocities on every platform, and they are independent of a packing of the same seed.
/// Throws std::invalid_argument unless `speed` is finite and >= 0.
void agitate(Assembly& assembly, double speed, std::uint64_t seed);

}  // namespace flowslide
