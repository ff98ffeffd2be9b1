// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <string>
#include <vector>

#include "record/series.hpp"

namespace flowslide {

/// The health of a sample for people, from the numbers of a result (see sample_library/sample_health.hpp):
/// "e0 0.782 (inner 0.767), slices +-0.012, seam 0.004, order 0.03, contacts 4.6, rattlers 9 %, fabric 0.017",
/// the largest along any axis; empty for a result without these numbers, such as one of a closed-form sample.
std::string health_line(const std::vector<Metric>& metrics);

}  // namespace flowslide
