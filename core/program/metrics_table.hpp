// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <map>
#include <string>

namespace flowslide {

/// The table metrics.dat: the numbers of all runs that claims may be about, one a row. Columns: run; metric; value, in
/// SI units. `metrics`: value by "<run>.<metric>" for a run, by "<curve>.<metric>.<statistic>" for its replicates, and
/// by a name without a dot for what compares runs, whose column "run" is "-". Runs may have different metrics.
std::string metrics_table(const std::map<std::string, double>& metrics);

}  // namespace flowslide
