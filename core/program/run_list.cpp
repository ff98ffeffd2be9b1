// SPDX-License-Identifier: GPL-2.0-or-later
#include "program/run_list.hpp"

#include <fmt/format.h>

#include "record/gnuplot_table.hpp"

namespace flowslide {

std::string run_list(const std::vector<Point>& runs, const std::string& scale) {
  std::string text = table_head({{"run", "", "text", "name of the run", "", {}},
                                 {"curve", "", "text", "name that the replicates share", "", {}},
                                 {"scale", "", "text", "scale of the run", "", {}},
                                 {"grains", "N", "1", "number of grains; 0: closed form, or several samples", "", {}}});
  for (const Point& run : runs)
    text += fmt::format("{} {} {} {}\n", run.name, run.curve.empty() ? run.name : run.curve, scale, run.grains);
  return text;
}

}  // namespace flowslide
