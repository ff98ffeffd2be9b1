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

}  // namespace flowslide
