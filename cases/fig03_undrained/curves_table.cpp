// SPDX-License-Identifier: GPL-2.0-or-later
#include "curves_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "record/gnuplot_table.hpp"

namespace flowslide {

std::string curves_table(const std::vector<std::pair<std::string, std::vector<Metric>>>& curves) {
  std::vector<Column> columns{{"curve", "", "text", "name of the curve", "", {}}};
  for (const auto& [curve, metrics] : curves)
    for (const Metric& metric : metrics)
      if (std::ranges::find(columns, metric.name, &Column::name) == columns.end())
        columns.push_back({metric.name, "", metric.units, metric.long_name, "", {}});
  std::string text = table_head(columns);
  for (const auto& [curve, metrics] : curves) {
    text += curve;
    for (std::size_t i = 1; i < columns.size(); ++i) {
      const auto found = std::ranges::find(metrics, columns[i].name, &Metric::name);
      text += found == metrics.end() ? " nan" : fmt::format(" {:.9g}", found->value);
    }
    text += "\n";
  }
  return text;
}

}  // namespace flowslide
