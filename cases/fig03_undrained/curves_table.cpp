// SPDX-License-Identifier: GPL-2.0-or-later
#include "curves_table.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace flowslide {

std::string curves_table(const std::vector<std::pair<std::string, std::vector<Metric>>>& curves) {
  std::vector<std::string> names;
  for (const auto& [curve, metrics] : curves)
    for (const Metric& metric : metrics)
      if (std::find(names.begin(), names.end(), metric.name) == names.end()) names.push_back(metric.name);
  std::string text = "# curve";
  for (const std::string& name : names) text += "\t" + name;
  text += "\n";
  for (const auto& [curve, metrics] : curves) {
    text += curve;
    for (const std::string& name : names) {
      const auto found = std::find_if(metrics.begin(), metrics.end(), [&](const Metric& of) { return of.name == name; });
      text += found == metrics.end() ? "\tnan" : fmt::format("\t{:.9g}", found->value);
    }
    text += "\n";
  }
  return text;
}

}  // namespace flowslide
