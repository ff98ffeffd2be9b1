// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <string>

#include "coupling/slide.hpp"
#include "record/input_table.hpp"

namespace flowslide {

/// A loading table as a result keeps it: columns "time" (s) and "stress_change" (Pa). `file` is its name in the
/// configuration.
InputTable input_table(const std::string& file, const StressTable& table);

}  // namespace flowslide
