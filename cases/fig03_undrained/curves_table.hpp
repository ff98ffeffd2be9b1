// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "record/series.hpp"

namespace flowslide {

/// The metrics of curves as a table (see table_head), one row per curve. The first column is "curve"; one column per
/// metric follows, in the order in which the curves name them. "nan" for a metric that the curve does not have.
std::string curves_table(const std::vector<std::pair<std::string, std::vector<Metric>>>& curves);

}  // namespace flowslide
