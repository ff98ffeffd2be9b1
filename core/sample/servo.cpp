// SPDX-License-Identifier: GPL-2.0-or-later
#include "sample/servo.hpp"

#include <algorithm>
#include <cmath>

namespace flowslide {
namespace {
constexpr double shear_gain = 5.0;
}

BoundaryMotion servo_motion(const ServoTarget& target, const Cell& cell, const CellStress& stress) {
  const auto rate = [&](double wanted, double present, double gain = 1.0) {
    return target.rate_limit * std::clamp(gain * (wanted - present) / target.normal, -1.0, 1.0);
  };
  BoundaryMotion motion;
  motion.compression_rate_x = rate(target.normal, stress.lateral_x);
  motion.compression_rate_y = rate(target.normal, stress.lateral_y);
  const double shortening = rate(target.normal, stress.normal) * cell.height();
  motion.top_velocity.z() = target.shear ? -shortening : -0.5 * shortening;
  motion.bottom_velocity.z() = target.shear ? 0.0 : 0.5 * shortening;
  if (target.shear) motion.top_velocity.x() = rate(*target.shear, stress.shear, shear_gain) * cell.height();
  return motion;
}

double servo_deviation(const ServoTarget& target, const CellStress& stress) {
  double deviation = 0.0;
  for (const double normal : {stress.normal, stress.lateral_x, stress.lateral_y})
    deviation = std::max(deviation, std::abs(normal - target.normal));
  if (target.shear) deviation = std::max(deviation, std::abs(stress.shear - *target.shear));
  return deviation / target.normal;
}

}  // namespace flowslide
