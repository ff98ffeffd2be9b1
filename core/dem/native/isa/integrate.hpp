// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "dem/native/contact_pass.hpp"
#include "dem/native/isa/row.hpp"

namespace flowslide::native {
inline namespace FLOWSLIDE_ISA {

inline double sum_of_three(Row row) { return row[0] + row[1] + row[2]; }

/// The motion pass (see MotionPass) with its part known at compile time. The last number of a row of forces is 0, so
/// that mass and inertia, which stand behind velocity and spin, stay what they are.
template <bool End, bool Begin>
inline double integrate(std::size_t count, double time_step, const double* kick, const double* twist,
                        const MeanFlow& flow, Body* bodies, Load* loads) {
  const Row drift{time_step, time_step, time_step, 0.0}, none{0.0, 0.0, 0.0, 0.0};
  const Row base = row_at(flow.base), slope = row_at(flow.slope);
  double fastest = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    Body& body = bodies[i];
    const Row kicked = kick[i] * row_at(loads[i].force), twisted = twist[i] * row_at(loads[i].torque);
    Row velocity = row_at(body.velocity) + kicked;
    Row spin = row_at(body.spin) + twisted;
    if constexpr (End && Begin) {
      velocity += kicked;
      spin += twisted;
    }
    put_row(body.velocity, velocity);
    put_row(body.spin, spin);
    if constexpr (Begin) {
      const Row fluctuation = velocity - (base + slope * (body.position[2] - flow.origin));
      const double squared = sum_of_three(fluctuation * fluctuation);
      fastest = squared > fastest ? squared : fastest;
      add_row(body.position, drift * velocity);
      put_row(loads[i].force, none);
      put_row(loads[i].torque, none);
    }
  }
  return fastest;
}

}  // namespace FLOWSLIDE_ISA
}  // namespace flowslide::native
