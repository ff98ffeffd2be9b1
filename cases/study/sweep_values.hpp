// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "sweep.hpp"

namespace flowslide {

/// Reads the values of `sweep.key` into `sweep`, with their unit. Values that are all numbers or quantities are sorted.
/// Their unit is that of the list, or the SI unit if the list has several. Throws ConfigurationError if two are equal.
void read_sweep_values(const Configuration& configuration, Sweep& sweep);

}  // namespace flowslide
