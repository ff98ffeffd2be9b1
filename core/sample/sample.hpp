// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <cstdint>
#include <limits>

#include "grains/cell_stress.hpp"
#include "sample/sample_state.hpp"

namespace flowslide {

/// Strain rates of a sample, 1/s, finite, relative to its height at the start of the run.
struct StrainRate {
  double shear = 0.0;        ///< d(gamma)/dt, positive when the top moves downslope (+x)
  double compression = 0.0;  ///< d(epsilon)/dt, positive when the sample becomes thinner; 0 keeps the volume
};

/// One run of a sample: a constant strain rate over some local time steps.
struct LocalRun {
  StrainRate rate;
  std::int64_t steps = 0;  ///< >= 0; the sign of a strain is that of its rate
  double time_step = 0.0;  ///< dt_L, s; of a DemSample: above 0, at most longest_time_step (sample/health.hpp)
                           ///< or the present stable_time_step
  /// False: the caller accepts the last measured stress, and the sample may skip the measurement.
  bool measured = true;

  /// t_DEM = n_step dt_L, s (eq. 15b).
  double duration() const { return static_cast<double>(steps) * time_step; }
};

/// Throws std::invalid_argument if the number of steps is negative.
void validate(const LocalRun& run);

/// A soil sample that returns stress for strain: the constitutive law of the slope.
class Sample {
 public:
  virtual ~Sample() = default;
  /// Strains the sample and returns its stress at the end. If the run is not measured, the stress may be that of the
  /// last measured run. Throws NumericalFailure.
  virtual CellStress strain(const LocalRun& run) = 0;
  virtual CellStress stress() const = 0;  ///< the stress that `strain` returned last, or the prepared stress
  /// p of the soil away from the boundaries, Pa, compression positive, kinetic stress included. Meant for records: one
  /// call may cost as much as many steps.
  virtual double mean_stress() const = 0;
  virtual double shear_strain() const = 0;  ///< gamma since the sample was prepared
  virtual double void_ratio() const = 0;

  /// A local time step (s) that is stable in the present state with a reserve, for the next call of `strain`. A closed
  /// form bears any: infinite.
  virtual double stable_time_step() { return std::numeric_limits<double>::infinity(); }

  /// The state for a checkpoint. Collective over the ranks that share the sample.
  virtual SampleState state() const = 0;
  /// Continues from `state`. Precondition: a sample of the same properties; it may have been strained. Throws
  /// std::invalid_argument if the state is that of another sample.
  virtual void restore(const SampleState& state) = 0;
};

}  // namespace flowslide
