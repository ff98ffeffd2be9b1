// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <vector>

#include "experiment/run_measures.hpp"
#include "record/series.hpp"

namespace flowslide {

/// The numbers that the claims about a curve are made of, from the record of an element test. `peak` is that of the
/// shear stress up to 5 % strain. Stresses relative to `initial_normal_stress` (sigma_0, Pa) are shares of 1. A metric
/// that the curve does not have (it ends before the window, say) is left out.
std::vector<Metric> curve_metrics(const Series& series, const StressPeak& peak, double initial_normal_stress);

}  // namespace flowslide
