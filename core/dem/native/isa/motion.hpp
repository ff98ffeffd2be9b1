// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <cmath>
#include <limits>

#include "dem/native/isa/row.hpp"
#include "dem/native/motion_pass.hpp"

namespace flowslide::native {
inline namespace FLOWSLIDE_ISA {

using Mask = decltype(DoubleRow{} < DoubleRow{});
inline double sum_of_three(DoubleRow row) { return row[0] + row[1] + row[2]; }
inline DoubleRow smaller(DoubleRow a, DoubleRow b) { return a < b ? a : b; }
inline DoubleRow larger(DoubleRow a, DoubleRow b) { return a > b ? a : b; }
inline bool any(Mask mask) { return (mask[0] | mask[1] | mask[2]) != 0; }

/// Destination of a moved grain, see MovingGrains.
template <bool Begin, typename Real>
inline Body<double>* after(const MovingGrains<Real>& g, std::size_t i) {
  if constexpr (Begin && std::is_same_v<Real, double>)
    return g.published + i;
  else
    return g.bodies + i;
}

/// The motion pass for a part that is known at compile time. The last number in a row of loads is 0. Mass and inertia,
/// which follow velocity and spin in memory, therefore do not change.
template <typename Real, bool End, bool Begin>
inline MotionExtremes move(double time_step, const MeanFlow& flow, const Box& box,
                           const MovingGrains<Real>& grains) {
  const DoubleRow drift{time_step, time_step, time_step, 0.0};
  const DoubleRow base = row_at(flow.base), slope = row_at(flow.slope);
  const DoubleRow lower = row_at(box.lower), upper = row_at(box.upper);
  DoubleRow lowest = lower, highest = lower, fastest{};
  const MovingGrains<Real> g = grains;  // a copy: the compiler then knows that stores do not change it
  const double origin = flow.origin;
  for (std::size_t i = g.begin; i < g.end; ++i) {
    Body<double>& body = g.bodies[i];
    Load<Real>& load = g.loads[i];
    const DoubleRow kicked = g.kick[i] * row_in_double(load.force);
    const DoubleRow twisted = g.twist[i] * row_in_double(load.torque);
    DoubleRow velocity = row_at(body.velocity) + kicked, spin = row_at(body.spin) + twisted;
    if constexpr (End && Begin) {
      velocity += kicked;
      spin += twisted;
    }
    Body<double>& moved = *after<Begin>(g, i);
    put_row(moved.velocity, velocity);
    put_row(moved.spin, spin);
    if constexpr (Begin) {
      const DoubleRow fluctuation = velocity - (base + slope * (body.position[2] - origin));
      fastest = larger(fluctuation * fluctuation, fastest);
      const DoubleRow position = row_at(body.position) + drift * velocity;
      lowest = smaller(position, lowest);
      highest = larger(position, highest);
      put_row(moved.position, position);
      put_row(load.force, Row<Real>{});
      put_row(load.torque, Row<Real>{});
      if constexpr (std::is_same_v<Real, double>) continue;
      Body<Real>& published = g.published[i];
      put_row(published.position, position);
      put_row(published.velocity, rounded<Real>(velocity));
      put_row(published.spin, rounded<Real>(spin));
    }
  }
  return {sum_of_three(fastest), any((lowest < lower) | (highest >= upper))};
}

/// See SlackPass.
template <typename Real>
inline double slack(const MeanDrift& drift, const Start* start, const MovingGrains<Real>& g) {
  const DoubleRow offset = row_at(drift.offset), gradient = row_at(drift.gradient);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = g.begin; i < g.end; ++i) {
    const DoubleRow from = row_at(start[i].position);
    const DoubleRow stray = row_at(g.bodies[i].position) - (from + offset + gradient * from[2]);
    const double left = start[i].allowance - std::sqrt(sum_of_three(stray * stray));
    least = left < least ? left : least;
  }
  return least;
}

/// Mask of the coordinates that are outside a box or NaN.
inline Mask outside(DoubleRow position, DoubleRow lower, DoubleRow upper) {
  return (position < lower) | (position > upper) | (position != position);
}

/// See MomentPass. Reads the positions of the contact pass, because they are in the cache.
template <typename Real>
inline Moments moments(const double* origin, const double* weight_of_glued, const Box& box,
                       const MovingGrains<Real>& g) {
  const DoubleRow at = row_at(origin), lower = row_at(box.lower), upper = row_at(box.upper);
  const DoubleRow one{1.0, 1.0, 1.0, 1.0}, glued = row_at(weight_of_glued);
  DoubleRow height_times_force{}, moment{};
  Mask lost{};
  for (std::size_t i = g.begin; i < g.end; ++i) {
    const DoubleRow position = row_at(g.published[i].position), arm = position - at;
    const DoubleRow force = row_in_double(g.loads[i].force);
    const bool mobile = g.kick[i] > 0.0;
    height_times_force += (mobile ? arm[2] : 0.0) * force;
    moment += arm * force * (mobile ? one : glued);
    lost |= outside(position, lower, upper);
  }
  Moments sums;
  sums.inside = g.end - g.begin;
  for (std::size_t i = g.begin; i < g.end && any(lost); ++i)  // rarely runs
    sums.inside -= any(outside(row_at(g.published[i].position), lower, upper));
  put_row(sums.height_times_force, height_times_force);
  put_row(sums.moment, moment);
  return sums;
}

}  // namespace FLOWSLIDE_ISA
}  // namespace flowslide::native
