// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <string>
#include <vector>

#include "program/case.hpp"

namespace flowslide {

/// The table runs.dat, from which a figure states its scale, its number of grains and its number of samples: one row
/// per run, in their order. Columns: run; curve, the name that its replicates share; scale; grains, 0 for a closed-form
/// sample and for a run on several samples.
std::string run_list(const std::vector<Point>& runs, const std::string& scale);

}  // namespace flowslide
