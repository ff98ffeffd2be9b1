// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <ctime>

#include "sample/sample.hpp"

namespace flowslide {

/// A prepared assembly in a DEM engine, sheared by its glued top layer while the bottom stands still and the lateral
/// periods are fixed. The height H of a strain is that between the planes, so that tau times the shear rate times the
/// volume is the power of the force on the top. A cell that is periodic along z has no layers: it is sheared across its
/// faces, homogeneously in the mean, and its height is the period.
class DemSample : public Sample {
 public:
  /// Loads the assembly, which needs glued layers unless z is periodic. Throws std::invalid_argument without them, with
  /// them in a cell that is periodic along z, for settings out of their bounds, or for a time step that is too long for
  /// the smallest grain, and NumericalFailure for one that is too long for the contacts (see check_contact_time_step).
  DemSample(Engine& engine, const Assembly& assembly, const EngineSettings& settings);

  /// Gives every mobile grain the velocity of simple shear at `shear_rate` (1/s) at its height above the bottom, or
  /// the middle of a cell that is periodic along z, on top of its own, and
  /// the spin of that field, half its curl: a sudden start of the top alone would send a wave through the sample, and
  /// grains without spin would all be twisted at once.
  void start_linear_velocity_field(double shear_rate);
  /// Does so before the first step, at the rate of the first strain.
  void start_linear_at_first_strain() { linear_at_first_strain_ = true; }

  /// A time step other than that of the settings is set first; std::invalid_argument if it is not possible. Whether it
  /// suits the contacts is looked at every `time_step_interval` steps.
  CellStress strain(const LocalRun& run) override;
  CellStress stress() const override { return stress_; }
  /// See bulk_mean_stress. Loops over all contacts.
  double mean_stress() const override;
  double shear_strain() const override { return shear_strain_; }
  double void_ratio() const override;
  /// Grains with their histories, clocks, stress, and the stress that the sample was prepared to.
  SampleState state() const override;
  /// For a sample that has just been loaded from the same prepared assembly.
  void restore(const SampleState& state) override;

  double time() const { return time_; }       ///< local clock, s
  std::int64_t steps() const { return steps_; }  ///< since the sample was loaded
  std::uint64_t size() const { return grains_; }  ///< number of grains
  /// Processor time that `strain` has taken so far on this rank, s, summed over its threads.
  double processor_seconds() const { return static_cast<double>(clock_ticks_) / CLOCKS_PER_SEC; }
  /// The grains now, checked: NumericalFailure if one has gone wrong.
  Assembly assembly() const;
  const EngineSettings& settings() const { return engine_.settings(); }

 private:
  void set_time_step(double time_step);
  void inspect_time_step();

  Engine& engine_;
  std::uint64_t grains_;
  double solid_volume_;
  double smallest_radius_;
  bool linear_at_first_strain_ = false;
  CellStress prepared_;
  double shear_strain_ = 0.0;
  double time_ = 0.0;
  std::int64_t steps_ = 0;
  std::clock_t clock_ticks_ = 0;
  std::int64_t next_inspection_ = 0;  ///< in steps: see time_step_interval
  CellStress stress_;
};

}  // namespace flowslide
