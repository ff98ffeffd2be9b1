// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <ctime>
#include <memory>

#include "dem/engine.hpp"
#include "sample/glued_layers.hpp"
#include "sample/sample.hpp"
#include "sample/strain_height.hpp"

namespace flowslide {

/// A prepared assembly in a DEM engine, sheared by its glued top layer. The bottom stands still, and the lateral
/// periods are fixed. Strains refer to the height that StrainHeight names. A cell that is periodic along z has no
/// layers. It is sheared across its faces, homogeneously in the mean, and its height is the period.
class DemSample : public Sample {
 public:
  /// Loads the assembly into an engine of its own. `settings` holds the material of the recipe, a time step and no
  /// drag. Throws std::invalid_argument for an empty pointer, for an incomplete assembly, for missing glued layers, for
  /// glued layers in a cell that is periodic along z, for settings out of their bounds, and for a time step that is too
  /// long for the smallest grain. Throws NumericalFailure for a time step too long for the contacts (see
  /// check_contact_time_step).
  DemSample(std::unique_ptr<Engine> engine, const Assembly& assembly, const EngineSettings& settings,
            StrainHeight strain_height = StrainHeight::cell);
  /// The same on an engine of the caller, which must outlive the sample and which nothing else may use meanwhile. The
  /// next sample on this engine replaces the grains: the earlier sample must not be used again.
  DemSample(Engine& engine, const Assembly& assembly, const EngineSettings& settings,
            StrainHeight strain_height = StrainHeight::cell);

  /// Adds the velocity field of simple shear at `shear_rate` (1/s) to every mobile grain, and half the curl of the
  /// field to its spin. The field is 0 at the bottom, or at the top of the bottom layer if strains refer to the height
  /// between the layers, or at mid-height of a cell that is periodic along z. Without the
  /// field, a sudden start of the top would send a wave through the sample. Without the spin, contacts would set all
  /// grains into rotation at once.
  void start_linear_velocity_field(double shear_rate);
  /// Calls start_linear_velocity_field before the first step, with the shear rate of the first run.
  void start_linear_at_first_strain() { linear_at_first_strain_ = true; }

  /// First sets the time step of the run if it is new. Throws std::invalid_argument if this step is not positive or
  /// too long, if the number of steps is negative, or if a rate is not finite; the sample is then unchanged. Checks the
  /// time step against the contacts every `time_step_interval` steps; throws NumericalFailure as the checks of
  /// health.hpp.
  CellStress strain(const LocalRun& run) override;
  CellStress stress() const override { return stress_; }
  /// See bulk_mean_stress. Costs a loop over all contacts.
  double mean_stress() const override;
  double shear_strain() const override { return shear_strain_; }
  double void_ratio() const override;
  /// See stable_time_step of sample/stable_time_step.hpp. Until the next call, runs may use steps up to this one, even
  /// if it exceeds the fraction of the Rayleigh time that limits other steps. Costs about 60 steps.
  double stable_time_step() override;
  /// Grains with their contact histories, clocks, present stress and the stress after the preparation.
  SampleState state() const override;
  /// Precondition: the sample was loaded from the same prepared assembly, with the same material, on the same kind of
  /// engine; it may have been strained since. Throws std::invalid_argument if the state is that of another sample or
  /// incomplete; the sample is then unchanged. Throws EngineError if a grain lies outside the cell.
  void restore(const SampleState& state) override;

  double time() const { return time_; }       ///< local clock, s
  std::int64_t steps() const { return steps_; }  ///< local steps since the preparation
  std::uint64_t size() const { return grains_; }  ///< number of grains
  /// Processor time of all calls of `strain` on this rank, s, summed over its threads.
  double processor_seconds() const { return static_cast<double>(clock_ticks_) / CLOCKS_PER_SEC; }
  /// The present grains. Throws NumericalFailure as check_assembly.
  Assembly assembly() const;
  const EngineSettings& settings() const { return engine_.settings(); }

 private:
  void set_time_step(double time_step);
  void inspect_time_step();

  std::unique_ptr<Engine> owned_;  ///< empty if the engine is the caller's
  Engine& engine_;
  std::uint64_t grains_;
  double solid_volume_;
  double smallest_radius_;
  LayerThickness rigid_;           ///< what the height of the cell and that of the strain differ by, m
  bool linear_at_first_strain_ = false;
  CellStress prepared_;
  double shear_strain_ = 0.0;
  double time_ = 0.0;
  std::int64_t steps_ = 0;
  std::clock_t clock_ticks_ = 0;
  double stable_time_step_ = 0.0;  ///< found last, s; 0: none
  std::int64_t since_inspection_ = 0;  ///< steps since the last check of the time step; `restore` does not change it
  CellStress stress_;
};

}  // namespace flowslide
