// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <map>
#include <string>

#include "experiment/ensemble.hpp"

namespace flowslide {

/// The errors of the slides that DEM_high is the reference of as a table in Markdown: a line per dt_G, a column per way
/// to pass the strain, and in each "error (rate applied over the rate asked for)": "<slide>.error" and, of the first
/// sample,
/// "<slide>.rate_share" of convergence.hpp. What was not run is empty; no text if nothing was.
std::string error_table(const Ensembles& slides, const std::map<std::string, double>& metrics);

}  // namespace flowslide
