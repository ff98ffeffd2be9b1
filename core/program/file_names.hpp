// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <string>
#include <vector>

namespace flowslide {

struct Point;

/// Refuses two things that would be written to one file, such as a run "RD_r2" beside the second replicate of "RD", or
/// a run "sweep" in a case whose figure reads sweep.dat. `tables` are the names, without an ending, of what the case
/// writes beside the files of its points. Throws ConfigurationError with both of them.
void refuse_names_that_meet(const std::vector<Point>& points, const std::vector<std::string>& tables);

}  // namespace flowslide
