// SPDX-License-Identifier: GPL-2.0-or-later
// Predicted and measured cost of runs.
#pragma once
#include <span>
#include <string>

#include "record/provenance.hpp"

namespace flowslide {

/// Cost of several runs. The times include only runs that have recorded both times.
struct Cost {
  int points = 0;                 ///< number of runs
  int recorded = 0;               ///< number of runs with recorded times
  double predicted_seconds = 0.0; ///< sum over the recorded runs, s
  double processor_seconds = 0.0; ///< sum over the recorded runs, s; see Provenance
};

Cost cost_of(std::span<const Provenance> points);

/// One line: "cost: 1 h 02 min of processor time, 58 min predicted".
std::string cost_text(const Cost& cost);

/// {"points": ..., "recorded": ..., "predicted_seconds": ..., "processor_seconds": ...}
std::string cost_json(const Cost& cost);

}  // namespace flowslide
