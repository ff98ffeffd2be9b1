// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <limits>
#include <vector>

#include "dem/native/passes.hpp"
#include "random_pairs.hpp"

namespace flowslide::native {

/// Grains with loads on them, one in three glued, of which a range moves.
template <typename Real>
struct MovingBodies {
  explicit MovingBodies(std::size_t count = 41, bool publishes = true) : loads(count), start(count) {
    Dice dice(8);
    for (std::size_t i = 0; i < count; ++i) {
      bodies.push_back(RandomPairs<double>::grain(dice));
      for (int axis = 0; axis < 3; ++axis) {
        loads[i].force[axis] = static_cast<Real>(dice.between(-1.0, 1.0));
        loads[i].torque[axis] = static_cast<Real>(dice.between(-1e-3, 1e-3));
        start[i].position[axis] = bodies[i].position[axis] + dice.between(-1e-4, 1e-4);
      }
      start[i].allowance = dice.between(0.0, 1e-3);
      kick.push_back(i % 3 == 0 ? 0.0 : 0.5 * pass_step / bodies[i].mass);
      twist.push_back(i % 3 == 0 ? 0.0 : 0.5 * pass_step / bodies[i].inertia);
      if (publishes) published.push_back(in_precision<Real>(bodies[i]));
    }
  }
  MovingGrains<Real> grains(std::size_t begin, std::size_t end) {
    Body<Real>* shown = published.data();
    if constexpr (std::is_same_v<Real, double>)
      if (published.empty()) shown = bodies.data();
    return {begin, end, kick.data(), twist.data(), bodies.data(), shown, loads.data()};
  }
  MovingGrains<Real> grains() { return grains(0, bodies.size()); }
  MotionExtremes move(const Passes<Real>& passes, MotionPart part) {
    return passes.motion(part, pass_step, flow, box, grains());
  }
  /// Where a part puts the grains.
  const std::vector<Body<double>>& after(MotionPart part) const {
    if constexpr (std::is_same_v<Real, double>)
      if (part != MotionPart::end && !published.empty()) return published;
    return bodies;
  }
  double slack(const Passes<Real>& passes) { return passes.slack(drift, start.data(), grains()); }
  Moments moments(const Passes<Real>& passes) {
    return passes.moments(origin, weight_of_glued, box, grains());
  }

  std::vector<Body<double>> bodies;
  std::vector<Body<Real>> published;
  std::vector<Load<Real>> loads;
  std::vector<Start> start;
  std::vector<double> kick, twist;
  MeanFlow flow{{0.1, 0.2, 0.3, 0.0}, {3.0, 2.0, 1.0, 0.0}, 0.01};
  MeanDrift drift{{1e-5, 2e-5, -1e-5, 0.0}, {1e-4, -2e-4, 3e-4, 0.0}};
  static constexpr double far = std::numeric_limits<double>::max();
  Box box{{-0.2, -0.05, -0.2, -far}, {0.2, 0.05, 0.2, far}};
  alignas(32) double origin[4] = {-0.2, -0.05, -0.2, 0.0};
  alignas(32) double weight_of_glued[4] = {1.0, 0.0, 0.0, 0.0};  // along x, which is periodic
};

}  // namespace flowslide::native
