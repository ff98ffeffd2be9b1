// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <map>
#include <string>
#include <vector>

#include "experiment/ensemble.hpp"
#include "friction_law.hpp"

namespace flowslide {

/// The steady states of all element tests named flow_*, one for each replicate.
std::vector<SteadyState> steady_states(const Ensembles& slides);

/// Adds metrics about several runs to `metrics`, from the runs that have results:
///   least_linearity               lowest R^2 of the velocity profiles after liquefaction, homogeneous samples
///   largest_glued_linearity       highest R^2 of these profiles, samples with glued layers
///   mu_s, mu_2, I_0               the friction law that fits the steady states best
///   mu_deviation                  RMS difference of the steady states from this law
///   mu_deviation_of_glass_beads   RMS difference of the steady states from the published law of glass beads
void add_answers(const Ensembles& slides, std::map<std::string, double>& metrics);

/// All answers as a table in Markdown, one row per question. A cell gives "median (lowest to highest)" of the
/// replicates.
std::string answers_table(const Ensembles& slides);

/// Median, lowest and highest largest velocity (m/s) over the number of grains. One row per slide whose name begins
/// with `pulse`.
Series sizes_series(const Ensembles& slides, const std::string& pulse);

}  // namespace flowslide
