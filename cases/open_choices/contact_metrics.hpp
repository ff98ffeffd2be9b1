// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <vector>

#include "grains/assembly.hpp"
#include "grains/material.hpp"
#include "record/series.hpp"

namespace flowslide {

/// Metrics of the contacts of a sample, which say what bounds its time step:
///   median_overlap, largest_overlap    m, of the contacts (see touching_pairs); left out without contacts
///   largest_free_overlap               m, of the contacts of two mobile grains; left out without such contacts
///   stable_time_step                   s, see sample/stable_time_step.hpp; left out if infinite
/// `time_step` (s) is a first guess of it.
std::vector<Metric> contact_metrics(const Assembly& grains, const Material& material, double time_step);

}  // namespace flowslide
