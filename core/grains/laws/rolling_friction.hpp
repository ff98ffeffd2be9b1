// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <tuple>

#include "grains/fields.hpp"

namespace flowslide::laws {

/// The parameter that all rolling parts share.
struct RollingFriction {
  double rolling_friction = 0.1;  ///< mu_r; 0 leaves out the rolling part

  bool operator==(const RollingFriction&) const = default;
  static constexpr auto fields() {
    return std::tuple{Field{"rolling_friction", &RollingFriction::rolling_friction, "1", Bounds::not_negative()}};
  }
};
static_assert(lists_every_member<RollingFriction>());

}  // namespace flowslide::laws
