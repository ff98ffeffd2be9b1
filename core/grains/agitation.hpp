// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <cstdint>

#include "grains/assembly.hpp"

namespace flowslide {

/// Gives the mobile grains random velocities. Each component is normal (see random.hpp) with the standard deviation
/// `speed` (m/s). Their volume-weighted mean is subtracted, so that the total momentum is 0. `seed` may have any value.
/// Equal seeds give equal velocities on every platform; they are independent of a packing with the same seed.
/// Throws std::invalid_argument unless `speed` is finite and >= 0.
void agitate(Assembly& assembly, double speed, std::uint64_t seed);

}  // namespace flowslide
