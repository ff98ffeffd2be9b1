// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <cmath>
#include <cstddef>

#include "dem/native/body.hpp"

namespace flowslide::native {

/// A linear field of velocities u = base + slope (z - origin), m/s: what the boundaries impose on the whole sample.
struct MeanFlow {
  alignas(32) double base[4];   ///< m/s, the last is 0
  alignas(32) double slope[4];  ///< 1/s, the last is 0
  double origin;                ///< m
};

/// A box; infinite along an axis that does not matter.
struct Box {
  alignas(32) double lower[4];  ///< m, the last is -infinity
  alignas(32) double upper[4];  ///< m, the last is infinity
};

/// Grains `begin` up to `end` of arrays that hold all of them. In double a beginning reads `bodies` and writes
/// `published`, the same array or another; in float it moves `bodies` and writes `published` as well.
template <typename Real>
struct MovingGrains {
  std::size_t begin, end;
  const double *kick, *twist;  ///< dt/2 m and dt/2 I_s of each grain, 0 for glued ones
  Body<double>* bodies;
  Body<Real>* published;  ///< what the contact pass reads, and the moment pass
  Load<Real>* loads;      ///< cleared by a beginning only
};

/// Which half kicks the motion pass does: that of the end of a step, that of the beginning with the drift, or both.
enum class MotionPart { end, begin, end_and_begin };

/// What the motion pass has seen after a beginning.
struct MotionExtremes {
  double fluctuation_squared = 0.0;  ///< m^2/s^2: no |v - u|^2 is larger; the sum of the largest of each component
  bool outside = false;              ///< whether a centre lies below `lower` or not below `upper` of the box

  void widen(const MotionExtremes& other) {
    fluctuation_squared = std::fmax(fluctuation_squared, other.fluctuation_squared);
    outside |= other.outside;
  }
};

/// Velocity Verlet: v <- v + dt/2 f/m, x <- x + dt v, spins likewise. A part with a beginning publishes the grains and
/// clears their loads.
template <typename Real>
using MotionPass = MotionExtremes (*)(MotionPart part, double time_step, const MeanFlow& flow, const Box& box,
                                      const MovingGrains<Real>& grains);

/// Where grains would be had they followed the boundaries' field since a list was built: x_0 + offset + gradient z_0.
struct MeanDrift {
  alignas(32) double offset[4] = {};    ///< m, the last is 0
  alignas(32) double gradient[4] = {};  ///< the last is 0

  /// Largest difference of the way of two grains for each m between them.
  double steepness() const {
    return std::sqrt(gradient[0] * gradient[0] + gradient[1] * gradient[1] + gradient[2] * gradient[2]);
  }
  void add(const MeanFlow& flow, double time_step) {
    for (int axis = 0; axis < 3; ++axis) {
      offset[axis] += time_step * (flow.base[axis] - flow.slope[axis] * flow.origin);
      gradient[axis] += time_step * flow.slope[axis];
    }
  }
};

/// Where a grain was when a list was built, and how far it may stray from the mean drift before the next, m.
struct alignas(32) Start {
  double position[3];
  double allowance;
};

/// Least over the grains of what is left of their allowances, m.
template <typename Real>
using SlackPass = double (*)(const MeanDrift& drift, const Start* start, const MovingGrains<Real>& grains);

/// Sums over grains that the stress of the cell is made of.
struct Moments {
  alignas(32) double height_times_force[4] = {};  ///< sum over mobile grains of (z - z of the origin) f, N m
  alignas(32) double moment[4] = {};              ///< sums of (x - x of the origin) f_x and so on, N m
  std::size_t inside = 0;                         ///< grains within the box or on its surface

  void operator+=(const Moments& other) {
    for (int axis = 0; axis < 3; ++axis) {
      height_times_force[axis] += other.height_times_force[axis];
      moment[axis] += other.moment[axis];
    }
    inside += other.inside;
  }
};

/// Sums over the grains. `origin`, m, has four numbers; `weight_of_glued` says with which weight glued grains count in
/// the moment along each axis.
template <typename Real>
using MomentPass = Moments (*)(const double* origin, const double* weight_of_glued, const Box& box,
                               const MovingGrains<Real>& grains);

}  // namespace flowslide::native
