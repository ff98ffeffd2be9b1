// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <map>
#include <string>

#include "experiment/ensemble.hpp"

namespace flowslide {

/// The errors of the slides whose reference is DEM_high, as a table in Markdown: one line per dt_G, one column per
/// passing. A cell gives "error (rate applied / rate asked for)": <slide>.error, and <slide>.rate_share of the first
/// sample (see convergence.hpp). The cell of a slide without result is empty. Without any result the text is empty.
std::string error_table(const Ensembles& slides, const std::map<std::string, double>& metrics);

/// The same errors for Fig. 7, as the table errors.dat with one row per slide: passing; time_step (s); error and
/// highest, median and highest error of the replicates; spread, that of DEM_high. NaN for a spread of fewer than two
/// samples.
std::string error_rows(const Ensembles& slides, const std::map<std::string, double>& metrics);

}  // namespace flowslide
