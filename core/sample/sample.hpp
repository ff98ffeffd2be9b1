// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <cstdint>

#include "dem/engine.hpp"
#include "sample/sample_state.hpp"

namespace flowslide {

/// Rates at which a sample is strained, 1/s, per height at the start of the run.
struct StrainRate {
  double shear = 0.0;        ///< gamma rate, positive when the top moves downslope (+x)
  double compression = 0.0;  ///< epsilon rate, positive when the sample becomes thinner; 0 keeps the volume
};

/// What a sample is to do: be strained at a constant rate for some local time steps.
struct LocalRun {
  StrainRate rate;
  std::int64_t steps = 0;
  double time_step = 0.0;  ///< dt_L, s
  /// False where the caller can do with the stress that was measured last: a sample may then save measuring it.
  bool measured = true;

  /// t_DEM = n_step dt_L, s (eq. 15b).
  double duration() const { return static_cast<double>(steps) * time_step; }
};

/// A piece of soil that answers strain with stress: the constitutive law of the slope.
class Sample {
 public:
  virtual ~Sample() = default;
  /// Strains the sample and returns the stress at the end, or after the last measured run. Throws NumericalFailure.
  virtual CellStress strain(const LocalRun& run) = 0;
  virtual CellStress stress() const = 0;
  /// p, Pa, compression positive, of the soil away from the boundaries, moving grains included. For records: it may
  /// cost as much as many steps.
  virtual double mean_stress() const = 0;
  virtual double shear_strain() const = 0;  ///< gamma since the sample was prepared
  virtual double void_ratio() const = 0;

  /// Where it stands, to be kept. Collective over the ranks that share the sample.
  virtual SampleState state() const = 0;
  /// Goes on from there: for a new sample of the same properties. Throws std::invalid_argument if the state is that of
  /// another sample.
  virtual void restore(const SampleState& state) = 0;
};

}  // namespace flowslide
