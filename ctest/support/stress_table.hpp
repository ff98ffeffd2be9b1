// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "experiment/loading_record.hpp"

namespace flowslide {

/// The table that input_table was given. Throws std::out_of_range if `input` has no such columns.
inline StressTable stress_table(const InputTable& input) {
  return {input.rows.column("time").values, input.rows.column("stress_change").values};
}

}  // namespace flowslide
