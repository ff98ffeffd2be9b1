// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <cmath>
#include <cstddef>

#include "dem/native/body.hpp"

namespace flowslide::native {

/// The linear velocity field that the boundaries impose on the whole sample: u = base + slope (z - origin), m/s.
struct MeanFlow {
  alignas(32) double base[4];   ///< m/s, the last number is 0
  alignas(32) double slope[4];  ///< 1/s, the last number is 0
  double origin;                ///< m
};

/// A box; infinite along an axis that is not checked.
struct Box {
  alignas(32) double lower[4];  ///< m, the last number is -infinity
  alignas(32) double upper[4];  ///< m, the last number is infinity
};

/// The grains `begin` to `end` - 1 in arrays of all grains. In double, MotionPart::begin reads `bodies` and writes
/// `published`, which may be the same array. In float, it moves `bodies` and also writes `published`.
template <typename Real>
struct MovingGrains {
  std::size_t begin, end;
  const double *kick, *twist;  ///< dt/(2 m) and dt/(2 I_s) of each grain, 0 for glued grains
  Body<double>* bodies;
  Body<Real>* published;  ///< grains as the contact pass and the moment pass read them
  Load<Real>* loads;      ///< cleared only by a part with a beginning
};

/// The half kicks of the motion pass: at the end of a step, at the beginning of a step with the drift, or both.
enum class MotionPart { end, begin, end_and_begin };

/// Extremes that the motion pass finds in a part with a beginning.
struct MotionExtremes {
  double fluctuation_squared = 0.0;  ///< upper bound of |v - u|^2, m^2/s^2: the sum of the largest squared components
  bool outside = false;              ///< whether a coordinate of a centre is < `lower` or >= `upper` of the box

  void widen(const MotionExtremes& other) {
    fluctuation_squared = std::fmax(fluctuation_squared, other.fluctuation_squared);
    outside |= other.outside;
  }
};

/// Velocity Verlet: v <- v + dt/2 f/m, x <- x + dt v, spins likewise. A part with a beginning writes `published` and
/// clears the loads.
template <typename Real>
using MotionPass = MotionExtremes (*)(MotionPart part, double time_step, const MeanFlow& flow, const Box& box,
                                      const MovingGrains<Real>& grains);

/// Displacement of grains that have followed the mean flow since a list was built: offset + gradient z_0.
struct MeanDrift {
  alignas(32) double offset[4] = {};    ///< m, the last number is 0
  alignas(32) double gradient[4] = {};  ///< the last number is 0

  /// Largest difference of the displacements of two grains per distance between them.
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

/// Position (m) of a grain when a list was built, and its largest allowed deviation (m) from the mean drift.
struct alignas(32) Start {
  double position[3];
  double allowance;
};

/// Smallest remaining allowance of the grains, m.
template <typename Real>
using SlackPass = double (*)(const MeanDrift& drift, const Start* start, const MovingGrains<Real>& grains);

/// Sums over grains for the stress of the cell.
struct Moments {
  alignas(32) double height_times_force[4] = {};  ///< sum over mobile grains of (z - z of the origin) f, N m
  alignas(32) double moment[4] = {};              ///< sums of (x - x of the origin) f_x, likewise for y and z, N m
  std::size_t inside = 0;                         ///< number of grains in the box or on its surface

  void operator+=(const Moments& other) {
    for (int axis = 0; axis < 3; ++axis) {
      height_times_force[axis] += other.height_times_force[axis];
      moment[axis] += other.moment[axis];
    }
    inside += other.inside;
  }
};

/// Sums over the grains. `origin` (m) and `weight_of_glued` have four numbers. The latter is the weight of glued grains
/// in the moment along each axis.
template <typename Real>
using MomentPass = Moments (*)(const double* origin, const double* weight_of_glued, const Box& box,
                               const MovingGrains<Real>& grains);

}  // namespace flowslide::native
