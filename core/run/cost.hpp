// SPDX-License-Identifier: GPL-2.0-or-later
// What points were predicted to cost, and what they cost.
#pragma once
#include <span>
#include <string>

#include "record/provenance.hpp"

namespace flowslide {

/// Of several points. Those whose files do not say what they cost count in none of the times.
struct Cost {
  int points = 0;
  int recorded = 0;               ///< points that say what they cost
  double predicted_seconds = 0.0; ///< of these
  double processor_seconds = 0.0; ///< of these, see Provenance
};

Cost cost_of(std::span<const Provenance> points);

/// One line for people: "cost: 1 h 02 min of processor time, 58 min predicted".
std::string cost_text(const Cost& cost);

}  // namespace flowslide
