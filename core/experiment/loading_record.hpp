// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <string>

#include "coupling/slide.hpp"
#include "record/input_table.hpp"

namespace flowslide {

/// A loading table in the form that a result stores: columns "time" (s) and "stress_change" (Pa, positive downslope).
/// `file` is its name in the configuration.
InputTable input_table(const std::string& file, const StressTable& table);

/// The inverse of input_table. Throws std::out_of_range if `input` does not have these columns.
StressTable stress_table(const InputTable& input);

}  // namespace flowslide
