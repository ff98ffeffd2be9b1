// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <map>
#include <string>

namespace flowslide {

/// The errors at I = 1e-2 as a table in Markdown: a line per dt_G, a column per way to pass the strain, and in each
/// "error (rate applied over the rate asked for)": "<slide>.error" and, of the first sample, "<slide>.rate_share" of
/// convergence.hpp. What was not run is empty; no text if nothing was.
std::string error_table(const std::map<std::string, double>& metrics);

}  // namespace flowslide
