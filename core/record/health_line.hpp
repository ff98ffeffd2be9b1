// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <string>
#include <vector>

#include "record/series.hpp"

namespace flowslide {

/// The health of a sample as one line, from the metrics of a result (see sample_library/sample_health.hpp):
/// "e0 0.782 (probe 0.767), slices +-0.012, seam 0.004, order 0.03, contacts 4.6, rattlers 9 %, fabric 0.017".
/// Of a measure along each axis it gives the largest magnitude. Empty for a result without these metrics, such as that
/// of a closed-form sample.
std::string health_line(const std::vector<Metric>& metrics);

}  // namespace flowslide
