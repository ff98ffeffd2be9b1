// SPDX-License-Identifier: GPL-2.0-or-later
// The parts of a configuration that all slides share, as the structures that they stand for. Each reader throws
// ConfigurationError; `tables` are where its keys stand, such as {"point.pulse.loading", "loading"}: a key is read from
// the first of them that has it. Keys that a choice does not need are accepted.
#pragma once
#include <string>
#include <vector>

#include "configuration/configuration.hpp"
#include "configuration/tables.hpp"
#include "coupling/slide.hpp"
#include "coupling/stop.hpp"
#include "experiment/loading_record.hpp"
#include "experiment/slide_run.hpp"

namespace flowslide {

/// history = "constant" (change, if it is not 0: applied at once), "rate" (rate; final_change or duration, if it ends),
/// "pulse" (amplitude, duration) or "table" (file, see Configuration::path).
StressHistory read_loading(const Configuration& configuration, const TableNames& tables);

/// The table of a loading that read_loading has read from a file; empty for one that needs no file.
std::vector<InputTable> loading_inputs(const Configuration& configuration, const TableNames& tables,
                                       const StressHistory& loading);

/// rate = "global", "constant" (that of inertial_number at the initial normal stress of the slope, Pa),
/// "constant_inertial_number" (inertial_number, smallest_rate, smallest_rate_from) or
/// "at_least_quasi_static" (inertial_number).
RateRule read_rate_rule(const Configuration& configuration, const TableNames& tables, const GrainScale& grains,
                        double initial_normal_stress);

/// passing = "whole_increment" (eq. 15), "accumulate_and_reset" or "carry_remainder" (eq. 18; n_accum) or
/// "variable_time_step" (eq. 17); local_time_step, most_steps. Whether dt_L suits the grains, check_time_step tells.
StrainPassing read_strain_passing(const Configuration& configuration, const TableNames& tables);

/// The two above, time_step, consolidation = "euler" or "exponential", residual = "fades", "left_out" or "stays",
/// shear_modulus and oedometric_modulus (upper bounds of the sample's); initial_velocity, stress_interval and, for a
/// sample that rests when liquefied, rest_stress with probed_strain and rested_strain if there. A dt_G beyond the
/// limit of stability that follows from them is refused unless allow_unstable, and so is an n_accum for which the slope
/// would swing unanswered (RD: n_accum dt_L beyond that limit) or the sample pass its peak unseen (else: a portion of
/// more than `largest_portion` strain). The loading is left to read_loading.
inline constexpr double largest_portion = 1e-3;  ///< strain; loose samples have their peak at some 5e-3
SlideSettings read_coupling(const Configuration& configuration, const TableNames& tables, const SlopeProperties& slope,
                            const GrainScale& grains);

/// end_time; end_shear_strain and sliding_velocity if there.
StopConditions read_stop(const Configuration& configuration, const TableNames& tables);

/// most_rows; row_interval (s) and row_strain if there, at least one of them.
RowSpacing read_row_spacing(const Configuration& configuration, const TableNames& tables);

/// Refuses slope.angle if tau_0 reaches what a sample of this friction bears under sigma_0.
void check_strength(const Configuration& configuration, const SlopeProperties& slope, double friction);

}  // namespace flowslide
