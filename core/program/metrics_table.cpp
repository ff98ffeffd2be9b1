// SPDX-License-Identifier: GPL-2.0-or-later
#include "program/metrics_table.hpp"

#include <fmt/format.h>

#include "record/gnuplot_table.hpp"

namespace flowslide {

std::string metrics_table(const std::map<std::string, double>& metrics) {
  std::string text = table_head({{"run", "", "text", "run, or curve of several replicates; - compares runs", "", {}},
                                 {"metric", "", "text", "metric of the run, or of its replicates", "", {}},
                                 {"value", "", "SI", "its value", "", {}}});
  for (const auto& [name, value] : metrics) {
    const std::size_t dot = name.find('.');  // no name of a run has one
    const bool of_a_run = dot != std::string::npos;
    text += fmt::format("{} {} {}\n", of_a_run ? name.substr(0, dot) : "-", of_a_run ? name.substr(dot + 1) : name,
                        shortest(value));
  }
  return text;
}

}  // namespace flowslide
