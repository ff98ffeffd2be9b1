// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

namespace flowslide {

/// Leaves out shear that changes next to nothing: a liquefied sample bears no stress whatever it is strained by, until
/// its grains meet again. Once sigma has stayed at or below `normal_stress` over `probed_strain`, the sample rests over
/// the next `rested_strain`, which it is never given; then it is probed again. It is an approximation: strength comes
/// back later than it would. For quasi-static shear (RI) alone, since at the rate of the slope a liquefied sample does
/// resist. Not in the paper.
struct LiquefiedRest {
  double normal_stress = 30.0;   ///< Pa, > 0: sigma of a sample taken for liquefied
  double probed_strain = 0.01;   ///< > 0
  double rested_strain = 0.1;    ///< > 0
};

/// Where a sample is between a probe and the next, in strain.
struct RestState {
  double probed = 0.0;
  double rested = 0.0;
};

/// Throws std::invalid_argument if a value is out of its range.
void validate(const LiquefiedRest& rest);

/// Whether an increment of `strain` (its norm) is left out, where the sample last bore `normal_stress` (Pa); takes the
/// state on by it.
bool rests(const LiquefiedRest& rest, RestState& state, double strain, double normal_stress);

}  // namespace flowslide
