// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <string>

#include "coupling/slide.hpp"
#include "record/input_table.hpp"

namespace flowslide {

/// A loading table in the form that a result stores: columns "time" (s) and "stress_change" (Pa, positive downslope).
/// `file` is its name in the configuration.
InputTable input_table(const std::string& file, const StressTable& table);

}  // namespace flowslide
