// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <map>
#include <string>

namespace flowslide {

/// The table metrics.dat: the numbers of all runs that claims may be about, one a row. Columns: run; metric; value, in
/// SI units. `metrics`: value by "<run>.<metric>" for a run, "<curve>.<metric>.<statistic>" for its replicates, and by a
/// name without a dot for what compares runs, whose column "run" is "-". The number of rows of a run depends on what it
/// measured.
std::string metrics_table(const std::map<std::string, double>& metrics);

}  // namespace flowslide
