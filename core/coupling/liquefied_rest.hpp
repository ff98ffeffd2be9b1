// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

namespace flowslide {

/// Leaves out strain of a liquefied sample. Such a sample bears almost no stress until its grains touch again. When
/// sigma has stayed at or below `normal_stress` over the strain `probed_strain`, the sample rests: the next
/// `rested_strain` is never passed to it. Then the sample is probed again. This is an approximation: strength returns
/// later than without rest. Use it for quasi-static shear (RI) only, because at the strain rate of the slope a
/// liquefied sample does resist. Not in the paper.
struct LiquefiedRest {
  double normal_stress = 30.0;   ///< Pa, > 0: a sample with sigma up to this value counts as liquefied
  double probed_strain = 0.01;   ///< > 0
  double rested_strain = 0.1;    ///< > 0
};

/// Strain (its norm) passed in the present probe, and left out in the present rest.
struct RestState {
  double probed = 0.0;
  double rested = 0.0;
};

/// Throws std::invalid_argument if a value is out of its range.
void validate(const LiquefiedRest& rest);

/// Returns whether a strain increment is left out, and updates `state`. `strain` is the norm of the increment;
/// `normal_stress` is the last sigma of the sample, Pa.
bool rests(const LiquefiedRest& rest, RestState& state, double strain, double normal_stress);

}  // namespace flowslide
