// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <limits>
#include <tuple>

#include "grains/fields.hpp"
#include "grains/laws/contact.hpp"

namespace flowslide::laws {

/// The parameter that all normal parts share. Near the end of an impact the dashpot exceeds the spring, and F_n then
/// attracts. The limit replaces an attracting F_n by 0. The caps of the tangential and the rolling part follow F_n.
struct NormalForceLimit {
  bool normal_force_limited = false;  ///< F_n <- max(0, F_n)

  bool operator==(const NormalForceLimit&) const = default;
  static constexpr auto fields() {
    return std::tuple{Field{"normal_force_limited", &NormalForceLimit::normal_force_limited}};
  }
};
static_assert(lists_every_member<NormalForceLimit>());

/// The smallest F_n that is not replaced, N.
template <typename Real>
Real lowest_force(const NormalForceLimit& p) {
  return p.normal_force_limited ? Real(0) : std::numeric_limits<Real>::lowest();
}

/// The setting of LIGGGHTS' normal models.
inline constexpr LiggghtsSwitch limit_force{"limitForce", &NormalForceLimit::normal_force_limited};

}  // namespace flowslide::laws
