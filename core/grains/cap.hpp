// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <cstdint>

namespace flowslide {

/// Whether a contact history has the length that friction allows at most: mu |F_n| / k_t of a tangential spring,
/// mu_r |F_n| R* of a rolling torque. An engine whose law works in float says so, because its rounding hides it: F_n
/// may be a small difference of spring and dashpot, and is then known less well than the history. It has 32 bits, so
/// that a ContactHistory has no gap: ranks exchange it byte by byte.
enum class Cap : std::uint32_t { unknown, below, reached };

}  // namespace flowslide
