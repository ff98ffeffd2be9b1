// SPDX-License-Identifier: GPL-2.0-or-later
// Reads the settings of a slide from a configuration. `tables` lists where to look for a key, such as
// {"point.pulse.loading", "loading"}: a key is read from the first table that has it. Each reader throws
// ConfigurationError. Keys of the alternatives that are not chosen are allowed.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "configuration/configuration.hpp"
#include "configuration/tables.hpp"
#include "coupling/slide.hpp"
#include "coupling/stop.hpp"
#include "experiment/loading_record.hpp"
#include "experiment/slide_run.hpp"
#include "sample/recipe.hpp"

namespace flowslide {

/// Reads the history of the driving stress. Keys for each value of `history`:
///   "constant"  change (optional): a change of stress at time 0
///   "rate"      rate; duration or final_change (optional): end of the change
///   "pulse"     amplitude, duration
///   "table"     file: see Configuration::path
StressHistory read_loading(const Configuration& configuration, const TableNames& tables);

/// The table that read_loading has read from a file, for the result. Empty if the history needs no file.
std::vector<InputTable> loading_inputs(const Configuration& configuration, const TableNames& tables,
                                       const StressHistory& loading);

/// Reads the rule for the strain rate of the sample. Keys for each value of `rate`:
///   "global"                    none
///   "constant"                  inertial_number, at the initial normal stress of the slope (Pa)
///   "constant_inertial_number"  inertial_number, smallest_rate; smallest_rate_from (optional)
///   "at_least_quasi_static"     inertial_number
RateRule read_rate_rule(const Configuration& configuration, const TableNames& tables, const GrainScale& grains,
                        double initial_normal_stress);

/// Reads dt_L (s) from local_time_step. `moved` is the recipe of the sample whose grains make these steps; dt_L must
/// not exceed their longest time step. Null: the sample is a closed form, and any positive step is allowed.
double read_local_time_step(const Configuration& configuration, const TableNames& tables, const SampleRecipe* moved);

/// Reads largest_local_time_step (s), with which dt_L follows the contacts from `smallest` (s) on. Empty without this
/// key.
std::optional<AdaptiveTimeStep> read_adaptive_time_step(const Configuration& configuration, const TableNames& tables,
                                                        double smallest);

/// Reads dt_L (see read_local_time_step), most_steps and `passing`: "whole_increment" (eq. 15), "accumulate_and_reset"
/// or "carry_remainder" (eq. 18, with n_accum), or "variable_time_step" (eq. 17).
StrainPassing read_strain_passing(const Configuration& configuration, const TableNames& tables,
                                  const SampleRecipe* moved);

/// Largest strain that n_accum steps may pass at once. Loose samples reach their peak at a strain of about 5e-3.
inline constexpr double largest_portion = 1e-3;

/// Reads all settings of a slide except its loading (see read_loading). Keys beside those of the readers above:
/// time_step; consolidation = "euler" or "exponential"; residual = "fades", "left_out" or "stays"; shear_modulus and
/// oedometric_modulus (upper bounds for the sample, Pa); allow_unstable. Optional keys: initial_velocity,
/// stress_interval, and rest_stress with probed_strain and rested_strain (see LiquefiedRest), which are refused at
/// the rate of the slope and on a slope that drains.
///
/// Unless allow_unstable, three values are refused. dt_G must not exceed the limits of stability of sliding and, with
/// "euler", of consolidation. The stress is held for n_accum stress_interval steps of dt_L, or of its largest value. If
/// the sample is sheared at the rate of the slope, this time must not exceed the limit of sliding: the slope would
/// oscillate. The strain that these steps pass at the initial rate must not exceed `largest_portion`: the peak of the
/// shear stress would lie between two measurements.
///
/// `grains` gives the inertial numbers. `moved` is as for read_local_time_step.
SlideSettings read_coupling(const Configuration& configuration, const TableNames& tables, const SlopeProperties& slope,
                            const GrainScale& grains, const SampleRecipe* moved = nullptr);

/// Reads end_time; end_shear_strain, end_velocity and sliding_velocity are optional.
StopConditions read_stop(const Configuration& configuration, const TableNames& tables);

/// Reads most_rows, and at least one of row_interval (s) and row_strain.
RowSpacing read_row_spacing(const Configuration& configuration, const TableNames& tables);

/// Refuses slope.angle if tau_0/sigma_0 reaches `friction`, the largest stress ratio that the sample can bear.
void check_strength(const Configuration& configuration, const SlopeProperties& slope, double friction);

}  // namespace flowslide
