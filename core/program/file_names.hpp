// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <string>
#include <vector>

namespace flowslide {

struct Point;

/// Checks that no two outputs have the same file name. Examples of a conflict: a run "RD_r2" beside the second
/// replicate of "RD"; a run "sweep" in a case that writes sweep.dat for a figure. `tables`: names, without extension,
/// of the files that the case writes beside those of its runs. Throws ConfigurationError, with both owners of the name.
void refuse_names_that_meet(const std::vector<Point>& points, const std::vector<std::string>& tables);

}  // namespace flowslide
