// SPDX-License-Identifier: GPL-2.0-or-later
#include "mobility.hpp"

#include <fmt/format.h>

#include <cmath>

namespace flowslide {
namespace {

constexpr const char* loosest = "790";
constexpr const char* void_ratios[] = {loosest, "771", "765", "751"};

/// Statistics of a metric of the slides "<scheme>_e0_<name>"; NaN if there are none.
Statistics statistics(const Ensembles& slides, const std::string& scheme, const std::string& name,
                      const std::string& metric) {
  const auto found = slides.find(scheme + "_e0_" + name);
  if (found == slides.end()) return {};
  return statistics_of(found->second, metric);
}

void add_shares(const Ensembles& slides, const std::string& quantity, const std::string& metric,
                std::map<std::string, double>& metrics) {
  const auto median = [&](const std::string& scheme, const std::string& name) {
    return statistics(slides, scheme, name, metric).median;
  };
  for (const std::string name : void_ratios) {
    for (const char* scheme : {"RD", "RI"})
      metrics[fmt::format("{}_{}_{}_share", scheme, name, quantity)] =
          median(scheme, name) / median(scheme, loosest);
    metrics[fmt::format("RD_{}_{}_over_RI", name, quantity)] = median("RD", name) / median("RI", name);
  }
}

}  // namespace

void compare_void_ratios(const Ensembles& slides, std::map<std::string, double>& metrics) {
  add_shares(slides, "velocity", "largest_velocity", metrics);
  add_shares(slides, "runout", "runout", metrics);
  for (const std::string name : void_ratios) {
    const Statistics rd = statistics(slides, "RD", name, "runout"), ri = statistics(slides, "RI", name, "runout");
    metrics[name + "_largest_runout"] = std::fmax(rd.highest, ri.highest);
    metrics[name + "_runout_difference"] = std::abs(rd.median - ri.median);
  }
}

}  // namespace flowslide
