// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <vector>

#include "experiment/run_measures.hpp"
#include "record/series.hpp"

namespace flowslide {

/// Metrics of one curve, from the measured rows of its element test. `peak` is the peak of tau up to 5 % strain. Ratios
/// to `initial_normal_stress` (sigma_0, Pa) are fractions of 1. A metric that the curve does not have is left out, for
/// instance if the test ends before the window of the metric.
std::vector<Metric> curve_metrics(const Series& series, const StressPeak& peak, double initial_normal_stress);

}  // namespace flowslide
