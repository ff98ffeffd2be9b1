// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "record/series.hpp"

namespace flowslide {

/// The metrics of some curves as a table (see table_head): the column "curve" and one per metric; one row per curve.
/// Columns are in the order in which the curves name their metrics; a metric that a curve does not have is "nan" there.
std::string curves_table(const std::vector<std::pair<std::string, std::vector<Metric>>>& curves);

}  // namespace flowslide
