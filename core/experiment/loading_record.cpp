// SPDX-License-Identifier: GPL-2.0-or-later
#include "experiment/loading_record.hpp"

#include <utility>

namespace flowslide {

InputTable input_table(const std::string& file, const StressTable& table) {
  Series rows;
  rows.axis.values = table.time;
  rows.columns = {
      {"stress_change", "Delta tau_d", "Pa", "change of the driving shear stress", "positive downslope", table.change}};
  return {"loading", file, std::move(rows)};
}

}  // namespace flowslide
