// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <map>
#include <string>
#include <vector>

#include "experiment/ensemble.hpp"
#include "friction_law.hpp"

namespace flowslide {

/// The steady states of all slides named flow_*, one of each replicate.
std::vector<SteadyState> steady_states(const Ensembles& slides);

/// Numbers about several slides, from those that are there:
///   least_linearity, largest_glued_linearity   R^2 of the profiles after liquefaction, of homogeneous and glued samples
///   mu_s, mu_2, I_0, mu_deviation              the law that fits the steady states best, and what they differ from it by
///   mu_deviation_of_glass_beads                what they differ from the published law by
void add_answers(const Ensembles& slides, std::map<std::string, double>& metrics);

/// All answers as a table in Markdown: a row for each question, "median (lowest to highest)" of the replicates.
std::string answers_table(const Ensembles& slides);

/// One row per slide whose name starts with `pulse`, by the number of its grains: the largest velocity.
Series sizes_series(const Ensembles& slides, const std::string& pulse);

}  // namespace flowslide
