// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <cstdint>

namespace flowslide {

/// Whether a contact history is at its cap, the largest length that friction allows: mu |F_n| / k_t for a tangential
/// spring, mu_r |F_n| R* for a rolling torque. An engine with its law in float must report this, because rounding hides
/// it: F_n may be a small difference of spring and dashpot, with a larger relative error than the history. The type has
/// 32 bits, so that a ContactHistory has no padding: ranks exchange it byte by byte.
enum class Cap : std::uint32_t { unknown, below, reached };

}  // namespace flowslide
